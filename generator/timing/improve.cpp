// How far a model is from its limits, and how another registration order would do.
#include <algorithm>
#include <functional>
#include <tuple>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {
namespace {

/// Of one trial order or one factor; an ordinary robot needs some thousands.
constexpr Limits kOfTrial{1'000'000, 1'000, std::int64_t{1} << 22};

bool is_schedulable(const Model& model, Profile profile) {
  try {
    Effort effort(kOfTrial);
    const TaskSet set = make_task_set(model, profile);
    const Responses responses = bound_responses(set, effort);
    return std::none_of(responses.bucket.begin(), responses.bucket.end(), [](Duration r) { return r == kNone; });
  } catch (const Overflow&) {
    return false;
  }
}

/// Rounded up: a time that still fits fits exactly.
Duration scaled(Duration time, std::int64_t permille) { return ceil_div(time * permille, 1000); }

bool survives(const Model& model, Profile profile, std::optional<Rank> only, std::int64_t permille) {
  Model trial = model;
  try {
    for (const Rank d : trial.devices.ids()) {
      if (only && *only != d) continue;
      Device& device = trial.devices[d];
      device.update_wcet = scaled(device.update_wcet, permille);
      device.handle_wcet = scaled(device.handle_wcet, permille);
    }
  } catch (const Overflow&) {
    return false;
  }
  return is_schedulable(trial, profile);
}

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
  Effort effort(kOfTrial.steps, analysis.most_releases);
  const WireAnalysis wire(model, analysis, effort);
  for (const ChainResult& chain : ChainAnalysis(model, topology, analysis, wire, effort).defaults())
    score.add(chain.end_to_end ? chain.end_to_end : chain.decide);
}

Score score(const Model& model, Profile profile) {
  const Topology topology = make_topology(model);
  const ProfileAnalysis analysis = analyse_profile(model, topology, profile, kOfTrial);
  Score s;
  for (const TreeResult& tree : analysis.result.trees) s.add(tree.latency);
  const Profile of_chains = model.has_target ? Profile::target : Profile::tight;
  add_chains(model, topology, profile == of_chains ? analysis : analyse_profile(model, topology, of_chains, kOfTrial),
             s);
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

}  // namespace

std::int64_t slack_permille(const Model& model, Profile profile, std::optional<Rank> only) {
  if (!survives(model, profile, only, 0)) return 0;
  std::int64_t good = 0, bad = 1000;
  while (bad < kMostSlack && survives(model, profile, only, bad)) good = bad, bad *= 2;
  if (bad >= kMostSlack) return kMostSlack;
  while (bad - good > 1) {
    const std::int64_t middle = good + (bad - good) / 2;
    (survives(model, profile, only, middle) ? good : bad) = middle;
  }
  return good;
}

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

}  // namespace finemote::gen::timing
