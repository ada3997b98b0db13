#include "generator/wcet/mark_passes.hpp"

#include "generator/wcet/loop_marks.hpp"

namespace finemote::gen::wcet {
namespace {

/// An iteration that an interrupt adds, or one for each interrupt: not told of a loop by its own begin mark.
bool is_for_interrupts(std::uint32_t block, const Marks& marks) {
  return marks.retries.count(block) != 0 || marks.once_for_each.count(block) != 0;
}

/// Its mark counts for the loop around it. Outside of a loop it says nothing: a run does not count it either.
bool is_bounded(const Frame& frame, std::uint32_t block, const Marks& marks) {
  if (marks.loop_bounds.count(block) == 0) return false;
  const auto loop = frame.nest.around(block);
  if (!loop) return false;
  if (is_for_interrupts(block, marks)) return true;
  return loop != frame.unmarked && ends_loop_around(frame.nest, block, marks);
}

}  // namespace

bool is_passed_by_some(const Frame& frame, std::uint32_t block, const Marks& marks) {
  return is_bounded(frame, block, marks) && !frame.nest.is_on_every_turn(block);
}

bool pass_mark(Frame& frame, std::uint32_t block, const Marks& marks) {
  if (!is_bounded(frame, block, marks)) return true;
  const std::uint32_t besides = passes_besides(frame.nest.loops()[*frame.nest.around(block)], block, marks);
  std::uint32_t& passes = frame.passes[block];
  if (passes < marks.loop_bounds.at(block) + besides) return ++passes, true;
  frame.is_cut_by_mark = true;
  return false;
}

}  // namespace finemote::gen::wcet
