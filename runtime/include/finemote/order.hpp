// Proves at start that every child was constructed before its parent, for classes that cannot be constant-initialised.
#pragma once

#include <cstdint>
#include <utility>

#include "finemote/contract.hpp"

namespace finemote {

namespace detail {
inline std::uint32_t constructed = 0;  // zero-initialised: counts before any constructor can run
}

/// Which object in a row this one was, counted when its construction ends.
class ConstructionNumber {
 public:
  constexpr explicit ConstructionNumber(std::uint32_t number) : number_(number) {}

  /// 1 for the first object constructed; 0 as long as this one is not.
  [[nodiscard]] constexpr const std::uint32_t& construction_number() const { return number_; }

 private:
  std::uint32_t number_;
};

/// A `T` that knows the how-manieth object it was. Use as `inline finemote::Ordered<User> x{...};`: partially-ordered
/// initialisation keeps x behind every inline variable defined before it in each translation unit.
template <class T>
class Ordered : public T, public ConstructionNumber {  // T first: it is complete when the number is drawn
 public:
  template <class... Args>
  explicit Ordered(Args&&... args) : T(std::forward<Args>(args)...), ConstructionNumber(++detail::constructed) {}
};

/// One edge of the device forest between two ordered objects.
struct OrderCheck {
  const std::uint32_t& child;   ///< construction_number() of the child
  const std::uint32_t& parent;  ///< and of the parent
  const char* child_name;
  const char* parent_name;
};

/// Index of the first edge whose child is missing or was constructed after its parent, or `checks.size()`.
std::size_t first_order_violation(View<OrderCheck> checks);

}  // namespace finemote
