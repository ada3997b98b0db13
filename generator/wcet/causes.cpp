#include "generator/wcet/causes.hpp"

#include <set>

#include "generator/wcet/proven_bound.hpp"
#include "generator/wcet/without.hpp"

namespace finemote::gen::wcet {
namespace {

/// The longest way that some of these causes may take; none: there is none.
std::optional<Cycles> longest_of(Causes raised, const UnrolledGraph& graph, const Marks& marks) {
  std::set<std::uint32_t> others;
  for (const auto& [block, causes] : marks.raised) {
    if ((causes & raised) == 0) others.insert(block);
  }
  return proven_bound(without(graph, others));
}

Cycles sum_of(Causes raised, const CauseTimes& times) {
  Cycles sum = 0;
  for (const auto& [cause, cycles] : times) sum += (cause & raised) != 0 ? cycles : 0;
  return sum;
}

/// Those that a mark in the graph tells apart.
Causes told_apart(const UnrolledGraph& graph, const Marks& marks) {
  Causes all = 0;
  for (const UnrolledNode& node : graph.nodes) {
    const auto mark = marks.raised.find(node.block);
    if (mark != marks.raised.end()) all |= mark->second;
  }
  return all;
}

}  // namespace

CauseTimes times_by_cause(const UnrolledGraph& graph, const Marks& marks) {
  CauseTimes times;
  for (Causes cause = 1; cause <= kAllCauses; cause <<= 1U) {
    if (const auto longest = longest_of(cause, graph, marks)) times[cause] = *longest;
  }
  const Causes told = told_apart(graph, marks);
  for (Causes several = 1; several <= told; ++several) {
    if ((several & ~told) != 0) continue;
    const Cycles together = longest_of(several, graph, marks).value_or(0), sum = sum_of(several, times);
    if (together <= sum) continue;
    for (Causes cause = 1; cause <= several; cause <<= 1U) {
      if ((cause & several) != 0) times[cause] += together - sum;
    }
  }
  return times;
}

}  // namespace finemote::gen::wcet
