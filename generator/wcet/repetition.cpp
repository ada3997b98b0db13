#include "generator/wcet/repetition.hpp"

#include <algorithm>
#include <vector>

#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

bool leads_to(const BasicBlock& block, std::uint32_t to) {
  return std::any_of(block.edges.begin(), block.edges.end(), [&](const FlowEdge& edge) { return edge.to == to; });
}

/// What of the loop leads to `last` without passing the header, which `last` goes back to.
Blocks turn_by(const FlowGraph& graph, const Loop& loop, std::uint32_t last) {
  Blocks turn{loop.header, last};
  std::vector<std::uint32_t> open{last};
  while (!open.empty()) {
    const std::uint32_t next = open.back();
    open.pop_back();
    if (next == loop.header) continue;
    for (const std::uint32_t block : loop.blocks) {
      if (leads_to(graph.blocks.at(block), next) && turn.insert(block).second) open.push_back(block);
    }
  }
  return turn;
}

}  // namespace

bool stores_exclusively(const ProgramFunction& function, const BasicBlock& block) {
  const Instruction* i = function.body.at(block.begin);
  for (; i != nullptr && i->address < block.end; i = function.body.at(i->end())) {
    if (is_exclusive_store(i->id)) return true;
  }
  return false;
}

Blocks smallest_turn(const FlowGraph& graph, const Loop& loop, std::uint32_t with) {
  Blocks smallest = loop.blocks;
  for (const std::uint32_t last : loop.blocks) {
    if (!leads_to(graph.blocks.at(last), loop.header)) continue;
    Blocks turn = turn_by(graph, loop, last);
    if (turn.count(with) != 0 && turn.size() < smallest.size()) smallest = std::move(turn);
  }
  return smallest;
}

namespace {

/// The longest, by the nodes from `first` on. Those of what a block calls follow its own.
Cycles longest_of(const Blocks& turn, const Frame& frame, std::uint32_t header, const UnrolledGraph& graph,
                  std::size_t first) {
  Cycles longest = 0, sum = 0;
  bool is_in_turn = false;
  for (std::size_t node = first; node < graph.nodes.size(); ++node) {
    const UnrolledNode& n = graph.nodes[node];
    if (n.function == &frame.function) {
      is_in_turn = turn.count(n.block) != 0;
      if (n.block == header) sum = 0;
    }
    if (is_in_turn) sum += n.cost;
    longest = std::max(longest, sum);
  }
  return longest;
}

}  // namespace

bool is_long_repetition(const Frame& frame, std::size_t loop, const UnrolledGraph& graph, std::size_t first) {
  if (frame.is_cut_by_mark) return false;
  const Loop& all = frame.nest.loops()[loop];
  return std::any_of(all.blocks.begin(), all.blocks.end(), [&](std::uint32_t begin) {
    if (frame.nest.around(begin) != loop) return false;
    if (!stores_exclusively(frame.function, frame.function.graph.blocks.at(begin))) return false;
    const Blocks turn = smallest_turn(frame.function.graph, all, begin);
    return longest_of(turn, frame, all.header, graph, first) > kLongestRepetition;
  });
}

}  // namespace finemote::gen::wcet
