#include "generator/wcet/loop_marks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

template <class Places>
std::vector<std::uint32_t> marks_in(const LoopNest& nest, std::size_t index, const Places& places) {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t block : nest.loops()[index].blocks) {
    if (nest.around(block) == index && places.count(block) != 0) found.push_back(block);
  }
  return found;
}

}  // namespace

bool is_of_loop_around(const LoopNest& nest, std::uint32_t mark, const Marks& marks) {
  const auto index = nest.around(mark);
  const auto ids = marks.ids.find(mark);
  if (!index || ids == marks.ids.end() || ids->second.size() != 1) return false;
  const auto& blocks = nest.loops()[*index].blocks;
  return std::none_of(marks.begins.begin(), marks.begins.end(), [&](const auto& begin) {
    return begin.second == *ids->second.begin() && blocks.count(begin.first) != 0;
  });
}

bool ends_loop_around(const LoopNest& nest, std::uint32_t mark, const Marks& marks) {
  return nest.is_on_every_turn(mark) && is_of_loop_around(nest, mark, marks);
}

std::uint32_t passes_besides(const Loop& loop, std::uint32_t mark, const Marks& marks) {
  return marks.ids.count(mark) != 0 ? 0 : loop.passes_besides(mark);
}

std::string why_endless(const LoopNest& nest, std::size_t index, const Marks& marks) {
  std::vector<std::uint32_t> all = marks_in(nest, index, marks.loop_bounds);
  const std::vector<std::uint32_t> waits = marks_in(nest, index, marks.waits);
  all.insert(all.end(), waits.begin(), waits.end());
  const auto is_of_it = [&](std::uint32_t mark) { return is_of_loop_around(nest, mark, marks); };
  const auto ends_it = [&](std::uint32_t mark) { return ends_loop_around(nest, mark, marks); };
  if (all.empty()) return "a loop whose rounds are not known: bound it with LoopBound<n>";
  if (std::any_of(all.begin(), all.end(), ends_it))
    return fmt::format("a loop that may turn more often than is followed: {} times", kMostRounds);
  if (std::any_of(all.begin(), all.end(), is_of_it)) return "a mark that not every round of its loop passes";
  return "a loop whose rounds are not known: the marks in it are of others, which the compiler left out or made one of";
}

std::vector<std::uint32_t> waits_of(const LoopNest& nest, std::size_t index, const Marks& marks) {
  std::vector<std::uint32_t> waits = marks_in(nest, index, marks.waits);
  const auto is_other = [&](std::uint32_t mark) { return !ends_loop_around(nest, mark, marks); };
  waits.erase(std::remove_if(waits.begin(), waits.end(), is_other), waits.end());
  return waits;
}

}  // namespace finemote::gen::wcet
