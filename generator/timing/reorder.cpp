#include "generator/timing/reorder.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

std::vector<ChangedBound> tree_bounds(const Timing& timing, const Model& better) {
  const ProfileResult result = analyse_profile(better, make_topology(better), timing.asked).result;
  std::vector<ChangedBound> bounds;
  for (const TreeResult& tree : timing.verdict().trees) {
    const std::string& root = timing.model.devices[tree.root].name;
    const auto then = std::find_if(result.trees.begin(), result.trees.end(),
                                   [&](const TreeResult& t) { return better.devices[t.root].name == root; });
    bounds.push_back({root, tree.latency, then->latency});
  }
  return bounds;
}

std::optional<Duration> shown(const ChainResult& chain) { return chain.end_to_end ? chain.end_to_end : chain.decide; }

std::vector<ChangedBound> changed_chains(const Timing& timing, const Order& order, const Model& better) {
  AnalysisRequest request;
  request.profile = timing.asked;
  const auto place = [&](Rank d) {
    return Rank{static_cast<std::size_t>(std::find(order.begin(), order.end(), d) - order.begin())};
  };
  for (const ChainResult& chain : timing.chains) request.chains.push_back({place(chain.from), place(chain.to)});
  Diagnostics same_as_before;
  const auto then = analyse(better, request, same_as_before);
  if (!then) return {};
  std::vector<ChangedBound> bounds;
  for (std::size_t c = 0; c < timing.chains.size(); ++c) {
    const ChainResult& chain = timing.chains[c];
    const auto found = std::find_if(then->chains.begin(), then->chains.end(), [&](const ChainResult& other) {
      return other.from == request.chains[c].from && other.to == request.chains[c].to;
    });
    if (found == then->chains.end() || shown(*found) == shown(chain)) continue;
    bounds.push_back({timing.model.devices[chain.from].name + " -> " + timing.model.devices[chain.to].name,
                      shown(chain), shown(*found)});
  }
  return bounds;
}

}  // namespace

OrderEffect effect_of_order(const Timing& timing, const Order& order) {
  const Model better = reorder(timing.model, order);
  return {tree_bounds(timing, better), changed_chains(timing, order, better)};
}

}  // namespace finemote::gen::timing
