// The device contract: what a device class looks like and how a parent sees its children.
//
// A device is a plain class with
//   - a public member `state` of a type derived from Stamp, and `command` where it can be commanded;
//   - `void update()`: reads hardware and children, publishes `state` upward;
//   - `void handle()`: decides, writes the commands of its children, drives its own hardware;
//   - for an actuator `void safe()`: the output that does no harm; may interrupt its own update() or handle().
// update() and handle() run to completion and never wait: bring-up is a state inside them, with `valid = false`.
// A device knows no period and no bucket; where an edge crosses periods the generated code moves copies.
// No heap, no exceptions, no RTTI, no recursion; the class is trivially destructible.
//
// The constructor takes, in this order and leaving out what does not apply: `const Config&` (for every param of the
// descriptor a member of its name, which generated code assigns), geometry constants, the bus endpoint, the `use`
// endpoints, one port per role: `Port<I>` for a role with exactly one child, `Ports<I>` for every other. It is
// constexpr wherever the class allows.
#pragma once

#include <cstddef>
#include <type_traits>

#include "finemote/time.hpp"

namespace finemote {

/// What every State and Command begins with.
struct Stamp {
  Time origin = 0;     ///< when the oldest data this value was made from was taken from the world
  bool valid = false;  ///< false: never set, or not to be used; `origin` then says nothing
};

/// True when `value` may be used at `at`: it is valid and its data is not older than `max_age`.
constexpr bool is_fresh(const Stamp& value, Time at, Duration max_age) {
  return value.valid && at - value.origin <= max_age;
}

/// What a parent sees of a child that offers interface `I`: its state, and its command where the interface has one.
/// Inside a bucket both refer to the child's own members; across buckets to copies that the schedule moves.
template <class I, class Command = typename I::Command>
struct Port {
  using Interface = I;
  static_assert(std::is_base_of_v<Stamp, typename I::State>, "a State derives publicly from finemote::Stamp");
  static_assert(std::is_base_of_v<Stamp, Command>, "a Command derives publicly from finemote::Stamp");
  const typename I::State& state;  ///< the child's, as it was when the parent's stage began
  Command& command;                ///< for the child: set its values, `origin` and `valid`
};

/// The same of a child without a command: a sensor.
template <class I>
struct Port<I, void> {
  using Interface = I;
  static_assert(std::is_base_of_v<Stamp, typename I::State>, "a State derives publicly from finemote::Stamp");
  const typename I::State& state;  ///< the child's, as it was when the parent's stage began
};

/// A view of constants: pointer and count. Made from an array, or from nullptr or nothing for none.
template <class T>
class View {
 public:
  constexpr View() = default;
  constexpr View(std::nullptr_t) {}  ///< of nothing
  /// Of a whole array, which outlives the view.
  template <std::size_t N>
  constexpr View(const T (&items)[N]) : first_(items), count_(N) {}
  constexpr View(const T* first, std::size_t count)
      : first_(first), count_(count) {}  ///< of `count` items side by side

  [[nodiscard]] constexpr std::size_t size() const { return count_; }  ///< number of items
  [[nodiscard]] constexpr bool empty() const { return count_ == 0; }   ///< whether there is none
  /// `i` < size(); not checked.
  constexpr const T& operator[](std::size_t i) const { return first_[i]; }
  [[nodiscard]] constexpr const T* begin() const { return first_; }         ///< for range-based loops
  [[nodiscard]] constexpr const T* end() const { return first_ + count_; }  ///< for range-based loops

 private:
  const T* first_ = nullptr;
  std::size_t count_ = 0;
};

/// The children of one role, in document order.
template <class I>
using Ports = View<Port<I>>;

}  // namespace finemote
