#include "generator/wcet/without.hpp"

#include <optional>

namespace finemote::gen::wcet {

UnrolledGraph without(const UnrolledGraph& graph, const std::set<std::uint32_t>& blocks) {
  UnrolledGraph left;
  std::vector<std::optional<std::size_t>> place(graph.nodes.size());  // in what is left
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    UnrolledNode kept = graph.nodes[node];
    kept.from.clear();
    for (const UnrolledEdge& edge : graph.nodes[node].from) {
      if (place[edge.from]) kept.from.push_back({*place[edge.from], edge.cost});
    }
    const bool is_reached = node == 0 || !kept.from.empty();
    if (!is_reached || blocks.count(kept.block) != 0) continue;
    place[node] = left.nodes.size();
    left.nodes.push_back(std::move(kept));
  }
  for (const std::size_t exit : graph.exits) {
    if (place[exit]) left.exits.push_back(*place[exit]);
  }
  return left;
}

}  // namespace finemote::gen::wcet
