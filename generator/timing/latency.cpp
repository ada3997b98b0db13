#include "generator/timing/latency.hpp"

#include <algorithm>

#include "generator/timing/oldest.hpp"
#include "generator/units/hyperperiod.hpp"

namespace finemote::gen::timing {
namespace {

/// Below every age, also below the negative ones of root releases no terminal uses; two of them add without overflow.
constexpr Duration kLowest = floor_div(Duration::min(), 2);

using Use = OldestUse;

/// Keeps the older use; of equally old ones the first in [0, repetition).
void offer(Use& worst, Duration age, Duration release, Duration source) {
  if (age > worst.age || (age == worst.age && release < worst.release)) {
    worst.age = age, worst.release = release, worst.source = source;
  }
}

/// The oldest use per row of the release table of one period: with the same R and W, an older source is worse. Leaves
/// that share the hand-over share this, whatever their R- is, as R- of one leaf varies by at most `spread`.
class OldestUses {
 public:
  OldestUses(const HandOver& over, Duration period, Rank leaf, const ReleaseTable& table)
      : over_(over), period_(period), leaf_(leaf), table_(table), oldest_(table.rows(leaf)) {
    for (std::size_t row = 0; row < oldest_.size(); ++row) oldest_[row] = {kLowest, {}, {}, row};
  }

  /// Empty where it is beyond the limits.
  std::vector<Use> find(Duration spread, Effort& effort) {
    const auto repetition = oldest_.size() > 1 ? common_multiple(over_.length, table_.repeat(leaf_)) : over_.length;
    if (!repetition) return {};
    repetition_ = *repetition;
    const std::int64_t most_uses = steps_in(*over_.down, over_.length) + steps_in(*over_.up, over_.length);
    if (!effort.spend(most_uses + static_cast<std::int64_t>(oldest_.size()))) return {};
    const std::vector<TerminalUse> uses = join(*over_.down, *over_.up, over_.length);
    const Duration least = oldest_age(uses) - period_ - spread;  // ages below cannot be part of a maximum
    Duration before = uses.back().next - over_.length;
    for (const TerminalUse& use : uses) {
      // Last one first; mostly the last one alone is old enough.
      for (Duration t = use.next - period_; t - use.source >= least && t >= before; t -= period_) {
        if (!effort.spend(floor_div(repetition_, over_.length))) return {};
        for (Duration shift; shift < repetition_; shift += over_.length) take(t + shift, t - use.source);
      }
      before = use.next;
    }
    std::erase_if(oldest_, [](const Use& use) { return use.age == kLowest; });
    std::sort(oldest_.begin(), oldest_.end(), [](const Use& a, const Use& b) { return a.age > b.age; });
    return std::move(oldest_);
  }

 private:
  void take(Duration t, Duration age) {
    Use& oldest = oldest_[oldest_.size() > 1 ? table_.row(leaf_, t) : 0];
    if (age < oldest.age) return;
    const Duration first = t - round_down(t, repetition_);
    offer(oldest, age, first, first - age);
  }

  const HandOver& over_;
  Duration period_;
  Rank leaf_;
  const ReleaseTable& table_;
  std::vector<Use> oldest_;
  Duration repetition_ = nanoseconds(1);
};

/// Of one leaf: `age` is the latency.
Use worst_use(const std::vector<Use>& oldest, Rank leaf, const ReleaseTable& table) {
  Use result{kLowest, {}, {}, 0};
  const Duration most = table.r_minus_range(leaf).most;
  for (const Use& use : oldest) {
    if (use.age + most < result.age) break;  // and so are all that follow
    const Duration response = table.r_minus_in_row(leaf, use.row);
    const Duration latency =
        use.age == Duration::zero() ? std::min(response, table.window_in_row(leaf, use.row)) : use.age + response;
    offer(result, latency, use.release, use.source);
  }
  return result;
}

class TreeBound {
 public:
  TreeBound(const Model& model, const Topology& topology, const TaskSet& set, const Responses& responses,
            const ReleaseTable& table, bool corollaries, HandOverStore& store, Effort& effort)
      : model_(model),
        topology_(topology),
        set_(set),
        responses_(responses),
        table_(table),
        corollaries_(corollaries),
        store_(store),
        effort_(effort),
        place_(model.devices.size()),
        is_general_(general_up_to_root(model, set, table)),
        spread_(set.buckets.size()) {
    for (const Rank d : model.devices.ids()) {
      const ReleaseTable::Range range = table.r_minus_range(d);
      Duration& spread = spread_[set.bucket_of[d]];
      spread = std::max(spread, range.most - range.least);
    }
  }

  TreeResult find(std::size_t tree) {
    result_ = {};
    result_.root = topology_.roots[tree];
    classify();
    for (const Rank leaf : topology_.leaves[tree]) {
      place_[leaf] = result_.paths.size();
      result_.paths.push_back({leaf, {}, {}, {}, false});
    }
    walk([this](const HandOverGroup& group) { visit(group); });
    summarise();
    return std::move(result_);
  }

 private:
  void classify() {
    bool same = true, harmonic = true;
    std::vector<Rank> stack{result_.root};
    while (!stack.empty()) {
      const Rank parent = stack.back();
      stack.pop_back();
      same &= model_.devices[parent].period == root_period();
      for (const Rank child : topology_.children[parent]) {
        harmonic &= is_multiple(model_.devices[parent].period, model_.devices[child].period);
        stack.push_back(child);
      }
    }
    result_.kind = same       ? TreeResult::Class::same_period
                   : harmonic ? TreeResult::Class::harmonic
                              : TreeResult::Class::general;
  }

  void walk(const std::function<void(const HandOverGroup&)>& visit) {
    walk_tree(model_, topology_, responses_, set_, table_, result_.root, store_, effort_, visit);
  }

  /// The latest of the group's leaves; kNone where it has none.
  [[nodiscard]] Duration latest_leaf(const HandOverGroup& group) const {
    Duration most = kNone;
    for (const Rank d : group.devices) {
      if (topology_.children[d].empty()) most = std::max(most, responses_.r_minus[d]);
    }
    return most;
  }

  void visit(const HandOverGroup& group) {
    if (latest_leaf(group) == kNone) return;
    const std::vector<Use>* oldest = group.exact != nullptr ? &oldest_uses(group) : nullptr;
    for (const Rank leaf : group.devices) {
      if (!topology_.children[leaf].empty()) continue;
      PathResult& path = result_.paths[place_[leaf]];
      if (group.exact == nullptr) {
        set_closed(path, group.closed.age, leaf);
      } else if (oldest->empty()) {
        set_closed(path, store_.closed_form(group.exact, group.period, root_period()).age, leaf);
      } else {
        set_exact(path, *oldest, leaf);
      }
    }
  }

  [[nodiscard]] Duration root_period() const { return model_.devices[result_.root].period; }

  /// Of a group with an exact hand-over; whoever shares it shares them. Empty where they are beyond the limits.
  const std::vector<Use>& oldest_uses(const HandOverGroup& group) {
    std::vector<Use>& oldest = store_.oldest_uses[group.exact];
    if (oldest.empty()) {
      const Rank any = group.devices.front();
      const Duration spread = spread_[set_.bucket_of[any]];
      oldest = OldestUses(*group.exact, group.period, any, table_).find(spread, effort_);
    }
    return oldest;
  }

  void set_closed(PathResult& path, Duration age, Rank leaf) const {
    const Duration response = responses_.r_minus[leaf];
    path.closed_form = true;
    path.latency = age == Duration::zero() ? std::min(response, table_.window(leaf)) : age + response;
  }

  void set_exact(PathResult& path, const std::vector<Use>& oldest, Rank leaf) const {
    const Use worst = worst_use(oldest, leaf, table_);
    path.latency = worst.age;
    path.closed_form = is_general_[leaf];
    if (path.closed_form) return;
    path.release = worst.release;
    path.source_release = worst.source;
  }

  void summarise() {
    Duration worst = kNone;
    for (const PathResult& path : result_.paths) {
      if (!path.latency) return;
    }
    for (const PathResult& path : result_.paths) {
      if (*path.latency <= worst) continue;
      worst = *path.latency;
      result_.worst_leaf = path.leaf;
      result_.worst_release = path.release;
      result_.source_release = path.source_release;
    }
    result_.latency = worst;
    const auto is_closed = [](const PathResult& path) { return path.closed_form; };
    result_.closed_form = std::any_of(result_.paths.begin(), result_.paths.end(), is_closed);
    if (!corollaries_) return;
    result_.cross_latency = cross_latency();
    if (result_.kind != TreeResult::Class::general) result_.corollary = corollary();
  }

  /// Over all pairs of leaves: what the terminal uses of the oldest source, and its response.
  Duration cross_latency() {
    OldestSources sources(root_period(), effort_);
    walk([&](const HandOverGroup& group) {
      if (latest_leaf(group) != kNone) sources.add_group(group, {{}, Rank{}});
    });
    Duration worst;
    walk([&](const HandOverGroup& group) {
      const Duration response = latest_leaf(group);
      if (response != kNone) worst = std::max(worst, sources.worst(group).age + response);
    });
    result_.closed_form |= sources.has_closed_form();
    return worst;
  }

  /// The paper's corollaries: in a same-period tree the worst R- of a leaf; in a harmonic tree every handle() of a
  /// slower parent adds what the floor of its response leaves, and updates never step back.
  Duration corollary() {
    Duration worst;
    std::vector<std::pair<Rank, Duration>> stack{{result_.root, {}}};
    while (!stack.empty()) {
      const auto [parent, age] = stack.back();
      stack.pop_back();
      const Duration period = model_.devices[parent].period;
      if (topology_.children[parent].empty()) worst = std::max(worst, age + responses_.r_minus[parent]);
      for (const Rank child : topology_.children[parent]) {
        const Duration faster = model_.devices[child].period;
        const Duration hop =
            faster == period ? Duration::zero() : period - faster + round_up(responses_.r_minus[parent], faster);
        stack.emplace_back(child, age + hop);
      }
    }
    return worst;
  }

  const Model& model_;
  const Topology& topology_;
  const TaskSet& set_;
  const Responses& responses_;
  const ReleaseTable& table_;
  bool corollaries_;
  HandOverStore& store_;
  Effort& effort_;
  TreeResult result_;
  Table<Rank, std::size_t> place_;  ///< of a leaf in result_.paths
  Table<Rank, bool> is_general_;    ///< of a device: the releases of one on its way to the root were not examined
  std::vector<Duration> spread_;    ///< per bucket: how much R- of one of its devices varies over the releases
};

}  // namespace

std::vector<TreeResult> bound_latencies(const Model& model, const Topology& topology, const TaskSet& set,
                                        const Responses& responses, const ReleaseTable& table, bool corollaries,
                                        HandOverStore& store, Effort& effort) {
  TreeBound bound(model, topology, set, responses, table, corollaries, store, effort);
  std::vector<TreeResult> trees;
  for (std::size_t tree = 0; tree < topology.roots.size(); ++tree) trees.push_back(bound.find(tree));
  return trees;
}

}  // namespace finemote::gen::timing
