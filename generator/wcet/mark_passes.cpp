#include "generator/wcet/mark_passes.hpp"

#include <optional>

namespace finemote::gen::wcet {
namespace {

/// Its mark counts in this try.
bool is_bounded(const Frame& frame, std::uint32_t block, const Marks& marks) {
  const auto loop = frame.nest.around(block);
  return marks.loop_bounds.count(block) != 0 && !(loop && loop == frame.unmarked);
}

/// A mark before the test of a loop is passed when the loop is left, too, which its source does not count.
std::uint32_t once_more(const Frame& frame, std::uint32_t mark) {
  const auto index = frame.nest.around(mark);
  if (!index) return 0;
  const Loop& loop = frame.nest.loops()[*index];
  return mark == loop.header && loop.begins_behind() ? 1 : 0;
}

}  // namespace

bool is_passed_by_some(const Frame& frame, std::uint32_t block, const Marks& marks) {
  return is_bounded(frame, block, marks) && frame.nest.around(block) && !frame.nest.is_on_every_turn(block);
}

bool pass_mark(Frame& frame, std::uint32_t block, const Marks& marks) {
  if (!is_bounded(frame, block, marks)) return true;
  std::uint32_t& passes = frame.passes[block];
  if (passes < marks.loop_bounds.at(block) + once_more(frame, block)) return ++passes, true;
  frame.is_cut_by_mark = true;
  return false;
}

}  // namespace finemote::gen::wcet
