#include "generator/wcet/gaps.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen::wcet {
namespace {

constexpr Cycles kInside = -1;  // no way comes here outside of stages

/// The marks at the start of a block.
struct Place {
  std::set<std::uint32_t> begun, ended;  ///< both named by their begin marks

  [[nodiscard]] bool is_any() const { return !begun.empty() || !ended.empty(); }
  /// A stage that is not empty begins here.
  [[nodiscard]] bool enters() const { return !std::includes(ended.begin(), ended.end(), begun.begin(), begun.end()); }
};

Place place_at(std::uint32_t block, const Marks& marks, std::uint32_t first_other) {
  Place place;
  const auto [first, last] = marks.brackets.equal_range(block);
  for (auto mark = first; mark != last; ++mark) {
    if (mark->second >= first_other) continue;
    (mark->second % 2 == 0 ? place.begun : place.ended).insert(mark->second & ~1U);
  }
  return place;
}

class GapSearch {
 public:
  GapSearch(const UnrolledGraph& graph, const Marks& marks, std::uint32_t first_other)
      : graph_(graph), marks_(marks), first_other_(first_other), since_(graph.nodes.size(), kInside) {}

  Gaps result() {
    for (std::size_t node = 0; node < graph_.nodes.size(); ++node) {
      since_[node] = node == 0 ? 0 : arriving(graph_.nodes[node]);
      pass(node);
    }
    Gaps gaps;
    for (auto& [block, gap] : before_) gaps.before.push_back(std::move(gap));
    for (const std::size_t exit : graph_.exits) gaps.rest = std::max(gaps.rest, behind(exit));
    return gaps;
  }

 private:
  /// Since the last stage, by the longest way outside of stages.
  [[nodiscard]] Cycles arriving(const UnrolledNode& node) const {
    Cycles longest = kInside;
    for (const UnrolledEdge& edge : node.from) {
      if (since_[edge.from] != kInside) longest = std::max(longest, behind(edge.from) + edge.cost);
    }
    return longest;
  }

  [[nodiscard]] Cycles behind(std::size_t node) const {
    return since_[node] == kInside ? 0 : since_[node] + graph_.nodes[node].cost;
  }

  void pass(std::size_t node) {
    const Place place = place_at(graph_.nodes[node].block, marks_, first_other_);
    if (!place.is_any()) return;
    if (since_[node] != kInside && !place.begun.empty()) {
      Gap& gap = before_[graph_.nodes[node].block];
      gap.begun = place.begun;
      gap.cycles = std::max(gap.cycles, since_[node]);
    }
    since_[node] = place.enters() ? kInside : 0;
  }

  const UnrolledGraph& graph_;
  const Marks& marks_;
  const std::uint32_t first_other_;
  std::vector<Cycles> since_;  // by node: since the entry or the end of the last stage
  std::map<std::uint32_t, Gap> before_;
};

}  // namespace

Gaps gaps_between(const UnrolledGraph& graph, const Marks& marks, std::uint32_t first_other) {
  return GapSearch(graph, marks, first_other).result();
}

}  // namespace finemote::gen::wcet
