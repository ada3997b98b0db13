// From when marked places of loops were passed to how often each was, at most, from when its loop was entered on.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "emulator/core/execution_log.hpp"

namespace finemote::emulator {

/// A place in the body of a loop, and the places around it: whoever passes one of those is not in the loop.
struct WatchedLoop {
  std::uint32_t place = 0;
  std::vector<std::uint32_t> borders = {};
  bool is_for_interrupts = false;  ///< each interrupt may add an iteration
};

/// Loops that are watched, by their index. Each level of preemption counts by itself: a loop that is interrupted by a
/// routine with the same loop goes on with its own count.
class LoopCounts {
 public:
  /// Of an event `ExecutionEvent::Kind::loop`.
  static constexpr std::uint32_t number_of(std::size_t loop, bool is_border) {
    return 2 * static_cast<std::uint32_t>(loop) + (is_border ? 1 : 0);
  }

  /// Passes of the place of this loop are counted without as many as interrupts have come since its routine began.
  void allow_interrupts(std::size_t loop) { for_interrupts_.insert(loop); }

  /// Events in the order of time; call it as often as there are some.
  void add(const ExecutionLog& log);

  /// How often the place was passed, at most. A loop that was never entered has none.
  [[nodiscard]] const std::map<std::size_t, std::uint64_t>& most() const { return most_; }

 private:
  struct Level {
    std::map<std::size_t, std::uint64_t> passes = {};  // so far, by loop
    std::uint64_t interrupts = 0;                      // that have come
  };

  void begin_level();
  void pass(std::uint32_t number);

  std::vector<Level> levels_{Level{}};
  std::map<std::size_t, std::uint64_t> most_;
  std::set<std::size_t> for_interrupts_;
};

}  // namespace finemote::emulator
