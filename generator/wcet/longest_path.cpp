#include "generator/wcet/longest_path.hpp"

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

constexpr Cycles kUnreached = -1;

/// Nodes are in the order of every way through them: one pass finds the longest.
class Search {
 public:
  explicit Search(const UnrolledGraph& graph)
      : graph_(graph), longest_(graph.nodes.size(), kUnreached), before_(graph.nodes.size()) {}

  void begin_at(std::size_t node) { reach(node, 0, node); }

  /// Ways into a node; those that come from a node for which `stops` holds do not count.
  template <class Stops>
  void enter(std::size_t node, Stops stops) {
    for (const UnrolledEdge& edge : graph_.nodes[node].from) {
      if (longest_[edge.from] != kUnreached && !stops(edge.from))
        reach(node, longest_[edge.from] + graph_.nodes[edge.from].cost + edge.cost, edge.from);
    }
  }

  [[nodiscard]] bool has_reached(std::size_t node) const { return longest_[node] != kUnreached; }
  [[nodiscard]] Cycles longest(std::size_t node) const { return longest_[node]; }
  [[nodiscard]] Potentials potentials() const { return longest_; }

  [[nodiscard]] std::vector<std::size_t> way_to(std::size_t node) const {
    std::vector<std::size_t> nodes{node};
    while (before_[nodes.back()] != nodes.back()) nodes.push_back(before_[nodes.back()]);
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

 private:
  void reach(std::size_t node, Cycles at, std::size_t from) {
    if (at <= longest_[node]) return;
    longest_[node] = at;
    before_[node] = from;
  }

  const UnrolledGraph& graph_;
  std::vector<Cycles> longest_;
  std::vector<std::size_t> before_;  // the predecessor on the longest way; a start node is its own
};

}  // namespace

std::optional<LongestPath> longest_path(const UnrolledGraph& graph) {
  if (graph.nodes.empty() || graph.exits.empty()) return std::nullopt;
  Search search(graph);
  search.begin_at(0);
  for (std::size_t node = 1; node < graph.nodes.size(); ++node) search.enter(node, [](std::size_t) { return false; });
  const auto end_of = [&](std::size_t exit) { return search.longest(exit) + graph.nodes[exit].cost; };
  const std::size_t last = *std::max_element(graph.exits.begin(), graph.exits.end(),
                                             [&](std::size_t a, std::size_t b) { return end_of(a) < end_of(b); });
  return LongestPath{search.potentials(), end_of(last), search.way_to(last)};
}

std::optional<LongestPath> longest_between(const UnrolledGraph& graph, const std::vector<bool>& from,
                                           const std::vector<bool>& to) {
  Search search(graph);
  std::optional<std::size_t> last;
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    search.enter(node, [&](std::size_t before) { return to[before]; });
    if (from[node] && !search.has_reached(node)) search.begin_at(node);
    const bool is_end = to[node] && search.has_reached(node);
    if (is_end && (!last || search.longest(node) > search.longest(*last))) last = node;
  }
  if (!last) return std::nullopt;
  std::vector<std::size_t> nodes = search.way_to(*last);
  nodes.pop_back();
  return LongestPath{search.potentials(), search.longest(*last), std::move(nodes)};
}

}  // namespace finemote::gen::wcet
