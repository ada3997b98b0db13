#include "emulator/core/loop_counts.hpp"

#include <algorithm>

namespace finemote::emulator {

void LoopCounts::add(const ExecutionLog& log) {
  using Kind = ExecutionEvent::Kind;
  for (const ExecutionEvent& event : log) {
    const bool ends_level = event.kind == Kind::tail || event.kind == Kind::resume;
    if (ends_level && levels_.size() > 1) levels_.pop_back();
    if (event.kind == Kind::enter || event.kind == Kind::tail) begin_level();
    if (event.kind == Kind::reset) levels_.assign(1, Level{});
    if (event.kind == Kind::loop) pass(event.number);
  }
}

void LoopCounts::begin_level() {
  for (Level& level : levels_) ++level.interrupts;
  levels_.emplace_back();
}

void LoopCounts::pass(std::uint32_t number) {
  const std::size_t loop = number / 2;
  Level& level = levels_.back();
  if (number == number_of(loop, true)) {
    level.passes.erase(loop);
    return;
  }
  const std::uint64_t passes = ++level.passes[loop];
  const std::uint64_t added = for_interrupts_.count(loop) != 0 ? std::min(level.interrupts, passes - 1) : 0;
  std::uint64_t& most = most_[loop];
  most = std::max(most, passes - added);
}

}  // namespace finemote::emulator
