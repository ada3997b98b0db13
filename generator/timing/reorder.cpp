#include "generator/timing/reorder.hpp"

#include <algorithm>
#include <tuple>

namespace finemote::gen::timing {
namespace {

/// What a chain is judged by: its end-to-end bound, where it has none that of its decision.
std::optional<Duration> shown(const ChainResult& chain) { return chain.end_to_end ? chain.end_to_end : chain.decide; }

/// Orders are judged by what analyze shows: the worst of tree latencies and chains, then their sum; unbounded is worst.
struct Score {
  Duration worst;
  long double total = 0;
  void add(std::optional<Duration> bound) {
    worst = std::max(worst, bound.value_or(kNever));
    total += static_cast<long double>(bound.value_or(kNever).ns());
  }
  friend bool operator<(const Score& a, const Score& b) {
    return std::tie(a.worst, a.total) < std::tie(b.worst, b.total);
  }
};

void add_chains(const Model& model, const Topology& topology, const ProfileAnalysis& analysis, Score& score) {
  Effort effort(kTrialLimits.steps, analysis.most_releases);
  const WireAnalysis wire(model, analysis, effort);
  for (const ChainResult& chain :
       ChainAnalysis(model, topology, analysis, wire, wire.acquisitions(), effort).defaults())
    score.add(shown(chain));
}

Score score(const Model& model, Profile profile) {
  const Topology topology = make_topology(model);
  const ProfileAnalysis analysis = analyse_profile(model, topology, profile, kTrialLimits);
  Score s;
  for (const TreeResult& tree : analysis.result.trees) s.add(tree.latency);
  const Profile of_chains = best_profile(model);
  add_chains(model, topology,
             profile == of_chains ? analysis : analyse_profile(model, topology, of_chains, kTrialLimits), s);
  return s;
}

/// None where a number of the analysis leaves 64 bits: no order to suggest.
std::optional<Score> judge(const Model& model, Profile profile) {
  try {
    return score(model, profile);
  } catch (const Overflow&) {
    return std::nullopt;
  }
}

/// A forest as nested lists of siblings; the order of registration is depth first, parents last.
struct Siblings {
  Table<Rank, std::vector<Rank>> lists;  ///< children of every device, and the roots as the last list
};

Order registration(const Siblings& siblings) {
  Order order;
  std::vector<Rank> stack = siblings.lists.back();
  while (!stack.empty()) {  // parents first and from behind, then the whole sequence reversed
    const Rank device = stack.back();
    stack.pop_back();
    order.push_back(device);
    for (const Rank child : siblings.lists[device]) stack.push_back(child);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

/// Orders that are tried: fewer where one analysis takes long.
int most_orders(std::size_t devices) {
  constexpr std::size_t kMost = 400, kLeast = 8, kDevices = 200'000;  // devices analysed in all
  return static_cast<int>(std::clamp(kDevices / std::max<std::size_t>(devices, 1), kLeast, kMost));
}

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

Model reorder(const Model& model, const Order& order) {
  Table<Rank, Rank> place(order.size());
  for (const Rank i : place.ids()) place[order[i]] = i;
  Model result = model;
  for (const Rank i : place.ids()) {
    Device& d = result.devices[i] = model.devices[order[i]];
    if (d.parent) d.parent = place[*d.parent];
    for (Rank& read : d.reads) read = place[read];
    for (Rank& end : d.ends_here) end = place[end];
  }
  for (Bus& bus : result.buses) {
    if (!bus.sources) continue;
    for (InterruptSource& source : *bus.sources) {
      for (FrameBudget& b : source.budgets) b.device = place[b.device];
      if (source.pin) source.pin->device = place[source.pin->device];
    }
  }
  for (Flush& flush : result.flushes) {
    for (Rank& d : flush.devices) d = place[d];
  }
  return result;
}

Order suggest_order(const Model& model, Profile profile) {
  Siblings siblings;
  siblings.lists.resize(model.devices.size() + 1);
  for (const Rank d : model.devices.ids()) {
    siblings.lists[model.devices[d].parent.value_or(model.devices.next_id())].push_back(d);
  }
  Order best;
  for (const Rank d : model.devices.ids()) best.push_back(d);
  std::optional<Score> best_score = judge(model, profile);
  int trials = 0;
  const int most = most_orders(model.devices.size());
  const auto try_order = [&] {
    ++trials;
    Order order = registration(siblings);
    const auto s = judge(reorder(model, order), profile);
    if (!s || !best_score || !(*s < *best_score)) return false;
    best_score = s;
    best = std::move(order);
    return true;
  };
  for (bool better = true; better && trials < most;) {
    better = false;
    for (auto& list : siblings.lists) {
      for (std::size_t i = 0; i + 1 < list.size() && trials < most; ++i) {
        // A device registered later starts later and ends earlier: move one behind its siblings at a time.
        const auto before = list;
        std::rotate(list.begin() + static_cast<std::ptrdiff_t>(i), list.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    list.end());
        if (try_order()) {
          better = true;
        } else {
          list = before;
        }
      }
    }
  }
  return best;
}

OrderEffect effect_of_order(const Timing& timing, const Order& order) {
  const Model better = reorder(timing.model, order);
  return {tree_bounds(timing, better), changed_chains(timing, order, better)};
}

}  // namespace finemote::gen::timing
