#include "generator/wcet/loop_marks.hpp"

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

/// Told by the source, neither a round that an interrupt adds nor one for each interrupt.
bool is_told(std::uint32_t place, const Marks& marks) {
  return marks.loop_bounds.count(place) != 0 && marks.retries.count(place) == 0 &&
         marks.once_for_each.count(place) == 0;
}

std::size_t ways_back(const FlowGraph& graph, const Loop& loop) {
  return static_cast<std::size_t>(std::count_if(loop.blocks.begin(), loop.blocks.end(), [&](std::uint32_t begin) {
    const auto& edges = graph.blocks.at(begin).edges;
    return std::any_of(edges.begin(), edges.end(), [&](const FlowEdge& edge) { return edge.to == loop.header; });
  }));
}

}  // namespace

LoopMarks marks_of(const FlowGraph& graph, const LoopNest& nest, std::size_t index, const Marks& marks) {
  const Loop& loop = nest.loops()[index];
  LoopMarks own;
  for (const std::uint32_t block : loop.blocks) {
    if (nest.around(block) == index && is_told(block, marks)) own.count += 1 + marks.shared_bounds.count(block);
  }
  own.are_its_own = own.count <= 1 && ways_back(graph, loop) <= 1;
  return own;
}

}  // namespace finemote::gen::wcet
