#include "generator/wcet/retries.hpp"

#include <algorithm>
#include <vector>

namespace finemote::gen::wcet {
namespace {

constexpr Cycles kNoWay = -1;

/// The longest way from the start of the mark's node through the graph and back over the last edges.
Cycles round_of(const Retry& retry, const UnrolledGraph& graph) {
  std::size_t last = retry.begin;
  for (const UnrolledEdge& edge : retry.back) last = std::max(last, edge.from);
  std::vector<Cycles> longest(last - retry.begin + 1, kNoWay);
  longest[0] = 0;
  const auto behind = [&](const UnrolledEdge& edge) {
    if (edge.from < retry.begin || longest[edge.from - retry.begin] == kNoWay) return kNoWay;
    return longest[edge.from - retry.begin] + graph.nodes[edge.from].cost + edge.cost;
  };
  for (std::size_t node = retry.begin + 1; node <= last; ++node) {
    for (const UnrolledEdge& edge : graph.nodes[node].from)
      longest[node - retry.begin] = std::max(longest[node - retry.begin], behind(edge));
  }
  Cycles round = 0;
  for (const UnrolledEdge& edge : retry.back) round = std::max(round, behind(edge));
  return round;
}

}  // namespace

void take_retries(const Walked& walked, RetryTimes& times) {
  for (const Retry& retry : walked.retries) {
    Cycles& longest = times[static_cast<std::size_t>(retry.by)];
    longest = std::max(longest, round_of(retry, walked.graph));
  }
}

}  // namespace finemote::gen::wcet
