#include "generator/wcet/certificate.hpp"

#include <fmt/format.h>

namespace finemote::gen::wcet {

std::string check_certificate(const UnrolledGraph& graph, const Potentials& potentials, Cycles bound) {
  if (potentials.size() != graph.nodes.size()) return "it is of another graph";
  if (graph.nodes.empty() || potentials[0] < 0) return "the entry has no potential";
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    if (graph.nodes[node].cost < 0) return fmt::format("node {} takes less than nothing", node);
    for (const UnrolledEdge& edge : graph.nodes[node].from) {
      if (edge.from >= node) return fmt::format("an edge leads back from node {} to {}", edge.from, node);
      if (edge.cost < 0) return fmt::format("an edge to node {} takes less than nothing", node);
      if (potentials[edge.from] < 0) return fmt::format("node {} has no potential", edge.from);
      if (potentials[node] < potentials[edge.from] + graph.nodes[edge.from].cost + edge.cost)
        return fmt::format("the way from node {} to {} is longer than their potentials say", edge.from, node);
    }
  }
  for (const std::size_t exit : graph.exits) {
    if (exit >= graph.nodes.size()) return "an exit is no node";
    if (potentials[exit] + graph.nodes[exit].cost > bound) return fmt::format("the way out of node {} is longer", exit);
  }
  return {};
}

}  // namespace finemote::gen::wcet
