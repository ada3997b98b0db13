#include "generator/timing/latency.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen::timing {
namespace {

/// Below every age, also below the negative ones of root releases no terminal uses; two of them add without overflow.
constexpr Ns kLowest = std::numeric_limits<Ns>::min() / 2;

using Use = HandOver::Use;

/// Keeps the older use; of equally old ones the first in [0, repetition).
void offer(Use& worst, Ns age, Ns release, Ns source) {
  if (age > worst.age || (age == worst.age && release < worst.release)) worst = {age, release, source};
}

/// The oldest use per row of the release table of one period: with the same R and W, an older source is worse. Leaves
/// that share the hand-over share this, whatever their R- is (at most `most_response`).
class OldestUses {
 public:
  OldestUses(const HandOver& over, Ns period, std::size_t leaf, const ReleaseTable& table)
      : over_(over), period_(period), leaf_(leaf), table_(table), oldest_(table.rows(leaf)) {}

  std::vector<Use> find(Ns most_response, Ns root_period, Effort& effort) {
    repetition_ = oldest_.size() > 1 ? lcm(over_.length, table_.repeat(leaf_)) : over_.length;
    effort.spend(repetition_ / root_period);
    const auto entries = over_.next.size();
    Ns worst = kLowest;
    for (std::size_t i = 0; i < entries; ++i) worst = std::max(worst, over_.next[i] - period_ - over_.source[i]);
    const Ns least = worst - most_response;  // ages below cannot be part of a maximum
    for (std::size_t i = 0; i < entries; ++i) {
      const Ns before = i > 0 ? over_.next[i - 1] : over_.next.back() - over_.length;
      // All terminals that use this root release, last one first; mostly the last one alone is old enough.
      for (Ns t = over_.next[i] - period_; t - over_.source[i] >= least; t -= period_) {
        for (Ns shift = 0; shift < repetition_; shift += over_.length) use(t + shift, over_.source[i] + shift);
        if (t - period_ < before) break;
      }
    }
    return std::move(oldest_);
  }

 private:
  void use(Ns t, Ns x) {
    Use& oldest = oldest_[oldest_.size() > 1 ? table_.row(leaf_, t) : 0];
    const Ns age = t - x;
    if (age < oldest.age) return;
    const Ns first = t - round_down(t, repetition_);
    offer(oldest, age, first, first - age);
  }

  const HandOver& over_;
  Ns period_;
  std::size_t leaf_;
  const ReleaseTable& table_;
  std::vector<Use> oldest_;
  Ns repetition_ = 1;
};

/// Of one leaf: `age` is the latency.
Use worst_use(const std::vector<Use>& oldest, std::size_t leaf, const ReleaseTable& table) {
  Use result;
  for (std::size_t row = 0; row < oldest.size(); ++row) {
    if (oldest[row].age == kLowest) continue;
    const Ns response = table.r_minus_in_row(leaf, row);
    const Ns latency =
        oldest[row].age == 0 ? std::min(response, table.window_in_row(leaf, row)) : add(oldest[row].age, response);
    offer(result, latency, oldest[row].release, oldest[row].source);
  }
  return result;
}

/// Worst sum of one terminal's and one source's age over all pairs of leaves of a tree. Two repetitions meet where
/// their entries agree modulo the common divisor of their lengths (Chinese remainder), so none is unrolled.
class CrossBound {
 public:
  void add_group(const HandOverGroup& group, Ns most_response, Ns root_period) {
    if (group.exact == nullptr) {
      closed_ = true;
      most_down_ = std::max(most_down_, add(group.down, most_response));
      most_up_ = std::max(most_up_, group.up);
      return;
    }
    const std::size_t n = group.exact->next.size();
    auto& [down, up] = ages_[n];
    down.resize(n, kLowest);
    up.resize(n, kLowest);
    Ns x = 0;
    for (std::size_t i = 0; i < n; ++i, x += root_period) {
      down[i] = std::max(down[i], add(group.exact->next[i] - group.period - x, most_response));
      up[i] = std::max(up[i], x - group.exact->source[i]);
    }
  }

  /// Pairs of lengths are looked at in the order of what they can reach at most, until none can reach more.
  Ns worst() {
    struct Pair {
      Ns most;
      const std::vector<Ns>* down;
      const std::vector<Ns>* up;
    };
    std::vector<Pair> pairs;
    for (const auto& [n, first] : ages_) {
      const Ns down = *std::max_element(first.down.begin(), first.down.end());
      most_down_ = std::max(most_down_, down);
      most_up_ = std::max(most_up_, *std::max_element(first.up.begin(), first.up.end()));
      for (const auto& [m, second] : ages_) {
        pairs.push_back({add(down, *std::max_element(second.up.begin(), second.up.end())), &first.down, &second.up});
      }
    }
    if (closed_) return add(most_down_, most_up_);
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.most > b.most; });
    Ns result = 0;
    for (const Pair& pair : pairs) {
      if (pair.most <= result) break;
      result = std::max(result, worst_pair(*pair.down, *pair.up));
    }
    return result;
  }

 private:
  static Ns worst_pair(const std::vector<Ns>& down, const std::vector<Ns>& up) {
    const std::size_t common = std::gcd(down.size(), up.size());
    const std::vector<Ns> a = fold(down, common), b = fold(up, common);
    Ns result = 0;
    for (std::size_t i = 0; i < common; ++i) result = std::max(result, add(a[i], b[i]));
    return result;
  }

  static std::vector<Ns> fold(const std::vector<Ns>& ages, std::size_t common) {
    std::vector<Ns> folded(ages.begin(), ages.begin() + static_cast<std::ptrdiff_t>(common));
    for (std::size_t block = common; block < ages.size(); block += common) {
      for (std::size_t i = 0; i < common; ++i) folded[i] = std::max(folded[i], ages[block + i]);
    }
    return folded;
  }

  struct Ages {
    std::vector<Ns> down, up;
  };
  std::map<std::size_t, Ages> ages_;  ///< by number of entries
  Ns most_down_ = 0, most_up_ = 0;
  bool closed_ = false;
};

class TreeBound {
 public:
  TreeBound(const Model& model, const Topology& topology, const TaskSet& set, const Responses& responses,
            const ReleaseTable& table, std::size_t tree, bool corollaries, HandOverStore& store, Effort& effort)
      : model_(model),
        topology_(topology),
        set_(set),
        responses_(responses),
        table_(table),
        tree_(tree),
        corollaries_(corollaries),
        store_(store),
        effort_(effort) {}

  TreeResult find() {
    result_.root = topology_.roots[tree_];
    classify();
    for (const std::size_t leaf : topology_.leaves[tree_]) {
      place_[leaf] = result_.paths.size();
      result_.paths.push_back({leaf, {}, {}, {}, false});
    }
    walk_tree(model_, topology_, responses_, set_, table_, result_.root, store_, effort_,
              [this](const HandOverGroup& group) { visit(group); });
    summarise();
    return std::move(result_);
  }

 private:
  void classify() {
    const Ns root_period = model_.devices[result_.root].period_ns;
    bool same = true, harmonic = true;
    std::vector<std::size_t> stack{result_.root};
    while (!stack.empty()) {
      const std::size_t parent = stack.back();
      stack.pop_back();
      same &= model_.devices[parent].period_ns == root_period;
      for (const std::size_t child : topology_.children[parent]) {
        harmonic &= model_.devices[parent].period_ns % model_.devices[child].period_ns == 0;
        stack.push_back(child);
      }
    }
    result_.kind = same       ? TreeResult::Class::same_period
                   : harmonic ? TreeResult::Class::harmonic
                              : TreeResult::Class::general;
  }

  void visit(const HandOverGroup& group) {
    const Ns root_period = model_.devices[result_.root].period_ns;
    Ns most_response = kNone;
    for (const std::size_t d : group.devices) {
      if (topology_.children[d].empty()) most_response = std::max(most_response, responses_.r_minus[d]);
    }
    if (most_response == kNone) return;  // no leaf
    if (group.exact != nullptr && group.exact->oldest.empty()) {
      const std::size_t any = group.devices.front();
      const Ns most = responses_.bucket[set_.bucket_of[any]];
      group.exact->oldest = OldestUses(*group.exact, group.period, any, table_).find(most, root_period, effort_);
    }
    for (const std::size_t d : group.devices) {
      if (topology_.children[d].empty()) set_path(result_.paths[place_.at(d)], group, d);
    }
    if (corollaries_) cross_.add_group(group, most_response, root_period);
  }

  void set_path(PathResult& path, const HandOverGroup& group, std::size_t leaf) {
    const Ns response = responses_.r_minus[leaf];
    if (group.exact == nullptr) {
      path.closed_form = true;
      path.latency_ns = group.age == 0 ? std::min(response, table_.window(leaf)) : add(group.age, response);
      return;
    }
    const Use worst = worst_use(group.exact->oldest, leaf, table_);
    path.latency_ns = worst.age;
    path.release_ns = worst.release;
    path.source_release_ns = worst.source;
  }

  void summarise() {
    Ns worst = kNone;
    for (const PathResult& path : result_.paths) {
      if (!path.latency_ns) return;
    }
    for (const PathResult& path : result_.paths) {
      if (*path.latency_ns <= worst) continue;
      worst = *path.latency_ns;
      result_.worst_leaf = path.leaf;
      result_.worst_release_ns = path.release_ns;
      result_.source_release_ns = path.source_release_ns;
    }
    result_.latency_ns = worst;
    if (!corollaries_) return;
    result_.cross_latency_ns = cross_.worst();
    if (result_.kind != TreeResult::Class::general) result_.corollary_ns = corollary();
  }

  /// The paper's corollaries: in a same-period tree the worst R- of a leaf; in a harmonic tree every handle() of a
  /// slower parent adds what the floor of its response leaves, and updates never step back.
  Ns corollary() {
    Ns worst = 0;
    std::vector<std::pair<std::size_t, Ns>> stack{{result_.root, 0}};
    while (!stack.empty()) {
      const auto [parent, age] = stack.back();
      stack.pop_back();
      const Ns period = model_.devices[parent].period_ns;
      if (topology_.children[parent].empty()) worst = std::max(worst, add(age, responses_.r_minus[parent]));
      for (const std::size_t child : topology_.children[parent]) {
        const Ns faster = model_.devices[child].period_ns;
        const Ns hop = faster == period ? 0 : add(period - faster, round_up(responses_.r_minus[parent], faster));
        stack.emplace_back(child, add(age, hop));
      }
    }
    return worst;
  }

  const Model& model_;
  const Topology& topology_;
  const TaskSet& set_;
  const Responses& responses_;
  const ReleaseTable& table_;
  std::size_t tree_;
  bool corollaries_;
  HandOverStore& store_;
  Effort& effort_;
  TreeResult result_;
  CrossBound cross_;
  std::map<std::size_t, std::size_t> place_;  ///< leaf -> index into result_.paths
};

}  // namespace

std::vector<TreeResult> bound_latencies(const Model& model, const Topology& topology, const TaskSet& set,
                                        const Responses& responses, const ReleaseTable& table, bool corollaries,
                                        HandOverStore& store, Effort& effort) {
  std::vector<TreeResult> trees;
  for (std::size_t tree = 0; tree < topology.roots.size(); ++tree) {
    trees.push_back(TreeBound(model, topology, set, responses, table, tree, corollaries, store, effort).find());
  }
  return trees;
}

}  // namespace finemote::gen::timing
