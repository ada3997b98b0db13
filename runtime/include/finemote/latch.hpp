// Moves a value between two periods (or an interrupt and a period) so that it is never seen half written.
//
// One processor, one writer, one reader; the more urgent side may interrupt the other anywhere and then runs to its
// end. No interrupt is masked and nothing waits. What is read is at least as fresh as the last publish() that had
// finished when snapshot() began, and never older than what was read before.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

#include "finemote/crossing.hpp"

namespace finemote {
namespace detail {

/// How a latch does its steps. Tests replace it to interrupt between any two of them.
struct Straight {
  template <class T>
  [[gnu::always_inline]] static void copy(T& to, const T& from) {
    to = from;
  }
  [[gnu::always_inline]] static void point() { std::atomic_signal_fence(std::memory_order_seq_cst); }
};

/// A word: narrower ones would have to be extended before each use.
using Index = std::atomic<std::uint32_t>;
inline std::uint32_t get(const Index& index) { return index.load(std::memory_order_relaxed); }
inline void set(Index& index, std::uint32_t value) { index.store(value, std::memory_order_relaxed); }

}  // namespace detail

/// Fast writer to slower reader: the writer may interrupt the reader, never the reverse.
/// Three slots: the writer fills one that is neither the latest nor being read.
template <class T, class Steps = detail::Straight>
class LatchToSlow {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>, "latched values are plain");
  static_assert(CheckedCrossing<T>::ok);

 public:
  constexpr LatchToSlow() = default;

  /// Writer side.
  void publish(const T& value) {
    const std::uint32_t slot = free_slot(detail::get(latest_), detail::get(reading_));
    Steps::point();
    Steps::copy(slots_[slot], value);
    Steps::point();
    detail::set(latest_, slot);
    Steps::point();
  }

  /// Reader side. The reference stays valid and unchanged until the next snapshot().
  const T& snapshot() {
    const std::uint32_t slot = detail::get(latest_);
    Steps::point();  // a writer here may refill `slot` with newer data, completely, before the reader goes on
    detail::set(reading_, slot);
    Steps::point();
    return slots_[slot];
  }

 private:
  static constexpr std::uint32_t free_slot(std::uint32_t a, std::uint32_t b) {
    return a != b ? 3 - a - b : static_cast<std::uint32_t>(a == 0);
  }

  T slots_[3]{};
  detail::Index latest_{0};
  detail::Index reading_{0};
};

/// Slow writer to faster reader: the reader may interrupt the writer, never the reverse.
/// Two slots: the writer fills the inactive one, then flips.
template <class T, class Steps = detail::Straight>
class LatchToFast {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>, "latched values are plain");
  static_assert(CheckedCrossing<T>::ok);

 public:
  constexpr LatchToFast() = default;

  /// Writer side.
  void publish(const T& value) {
    const std::uint32_t slot = detail::get(active_) ^ 1U;
    Steps::point();
    Steps::copy(slots_[slot], value);
    Steps::point();
    detail::set(active_, slot);
    Steps::point();
  }

  /// Reader side. The reference stays valid and unchanged until the reader's stage ends.
  const T& snapshot() const { return slots_[detail::get(active_)]; }

 private:
  T slots_[2]{};
  detail::Index active_{0};
};

}  // namespace finemote
