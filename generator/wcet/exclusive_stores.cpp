#include "generator/wcet/exclusive_stores.hpp"

#include <algorithm>

#include "generator/wcet/repetition.hpp"
#include "generator/wcet/turn_flow.hpp"

namespace finemote::gen::wcet {
namespace {

bool is_same(const Way& a, const Way& b) { return a.kind == b.kind && a.to == b.to && a.behind == b.behind; }

/// To the loop header and nowhere else, directly or through one block.
bool leads_back(const FlowGraph& graph, const Way& way, std::uint32_t header) {
  if (way.kind != Way::Kind::edge || way.to == header) return way.kind == Way::Kind::edge;
  const BasicBlock& next = graph.blocks.at(way.to);
  return !next.leaves && !next.call && next.edges.size() == 1 && next.edges.front().to == header;
}

/// Where the store fails there are further ways, and all of them lead back to the loop header.
bool fails_to(std::uint32_t header, const FlowGraph& graph, const Step& either, const Step& succeeding) {
  std::size_t further = 0, back = 0;
  for (const Way& way : either.ways) {
    const auto& ways = succeeding.ways;
    if (std::any_of(ways.begin(), ways.end(), [&](const Way& other) { return is_same(way, other); })) continue;
    ++further;
    back += leads_back(graph, way, header) ? 1 : 0;
  }
  return further > 0 && further == back;
}

}  // namespace

const ExclusiveStores::Known& ExclusiveStores::of(const Frame& frame) {
  const auto [entry, is_new] = known_.try_emplace(&frame.function);
  if (!is_new) return entry->second;
  Known& known = entry->second;
  const FlowGraph& graph = frame.function.graph;
  for (const auto& [begin, block] : graph.blocks) {
    if (!stores_exclusively(frame.function, block)) continue;
    Kind& kind = known.kinds[begin] = Kind::other;
    const auto around = frame.nest.around(begin);
    if (!around) continue;
    const Loop& loop = frame.nest.loops()[*around];
    const TurnFlow flow = turn_flow(frame.function, smallest_turn(graph, loop, begin), loop.header);
    if (flow.accumulates) continue;
    kind = Kind::retried;
    known.carried[loop.header].insert(flow.carried.begin(), flow.carried.end());
  }
  return known;
}

Step ExclusiveStores::step(const Frame& frame, const BasicBlock& block, Surroundings surroundings, const CodeCost& cost,
                           Machine machine) {
  const auto& kinds = of(frame).kinds;
  const auto found = kinds.find(block.begin);
  surroundings.exclusive_may_fail = found != kinds.end();
  if (found == kinds.end() || found->second != Kind::retried)
    return wcet::step(frame.function, block, surroundings, cost, std::move(machine));
  Step either = wcet::step(frame.function, block, surroundings, cost, machine);
  surroundings.exclusive_may_fail = false;
  Step succeeding = wcet::step(frame.function, block, surroundings, cost, std::move(machine));
  const std::uint32_t header = frame.nest.loops()[*frame.nest.around(block.begin)].header;
  return fails_to(header, frame.function.graph, either, succeeding) ? succeeding : either;
}

const Machine& ExclusiveStores::begin_turn(Frame& frame, std::size_t loop) {
  const std::uint32_t header = frame.nest.loops()[loop].header;
  Machine& machine = frame.arrivals[header]->machine;
  const auto& carried = of(frame).carried;
  const auto found = carried.find(header);
  if (found == carried.end()) return machine;
  for (const int reg : found->second) {
    if (Machine::follows(reg)) machine.set(reg, Value::in(Interval::any(), machine.get(reg).is_of_stack));
  }
  return machine;
}

}  // namespace finemote::gen::wcet
