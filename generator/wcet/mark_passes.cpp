#include "generator/wcet/mark_passes.hpp"

#include <optional>

namespace finemote::gen::wcet {
namespace {

/// Its mark counts in this try.
bool is_bounded(const Frame& frame, std::uint32_t block, const Marks& marks) {
  const auto loop = frame.nest.around(block);
  return marks.loop_bounds.count(block) != 0 && !(loop && loop == frame.unmarked);
}

}  // namespace

bool is_passed_by_some(const Frame& frame, std::uint32_t block, const Marks& marks) {
  return is_bounded(frame, block, marks) && frame.nest.around(block) && !frame.nest.is_on_every_turn(block);
}

bool pass_mark(Frame& frame, std::uint32_t block, const Marks& marks) {
  if (!is_bounded(frame, block, marks)) return true;
  const auto loop = frame.nest.around(block);
  const std::uint32_t besides = loop ? frame.nest.loops()[*loop].passes_besides(block) : 0;
  std::uint32_t& passes = frame.passes[block];
  if (passes < marks.loop_bounds.at(block) + besides) return ++passes, true;
  frame.is_cut_by_mark = true;
  return false;
}

}  // namespace finemote::gen::wcet
