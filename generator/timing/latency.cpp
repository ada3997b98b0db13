#include "generator/timing/latency.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen::timing {
namespace {

/// Below every age, also below the negative ones of root releases no terminal uses; two of them add without overflow.
constexpr Ns kLowest = std::numeric_limits<Ns>::min() / 2;

/// The worst terminal release found so far; of equally bad ones the first in [0, repetition).
struct Worst {
  Ns value = kLowest;
  Ns release = 0;
  Ns source = 0;

  void offer(Ns new_value, Ns t, Ns x) {
    if (new_value > value || (new_value == value && t < release)) *this = {new_value, t, x};
  }
};

/// Path latencies of the leaves of one group. They share hand-over and bucket, so per row of the release table only the
/// oldest use counts: with the same R and W, an older source is worse.
class GroupBound {
 public:
  /// @param most_response  largest R- of the leaves that will be asked about.
  GroupBound(const HandOverGroup& group, const ReleaseTable& table, Ns root_period, Ns most_response, Effort& effort)
      : table_(table), oldest_(table.rows(group.devices.front())) {
    const HandOver& over = *group.exact;
    const std::size_t leaf = group.devices.front();
    repetition_ = oldest_.size() > 1 ? lcm(over.length, table.repeat(leaf)) : over.length;
    effort.spend(repetition_ / root_period);
    const auto entries = over.next.size();
    Ns worst = kLowest;
    for (std::size_t i = 0; i < entries; ++i) worst = std::max(worst, over.next[i] - group.period - over.source[i]);
    const Ns least = worst - most_response;  // ages below cannot be part of a maximum
    for (std::size_t i = 0; i < entries; ++i) {
      const Ns before = i > 0 ? over.next[i - 1] : over.next.back() - over.length;
      // All terminals that use this root release, last one first; mostly the last one alone is old enough.
      for (Ns t = over.next[i] - group.period; t - over.source[i] >= least; t -= group.period) {
        for (Ns shift = 0; shift < repetition_; shift += over.length) offer(leaf, t + shift, over.source[i] + shift);
        if (t - group.period < before) break;
      }
    }
  }

  [[nodiscard]] Worst worst(std::size_t leaf) const {
    Worst result;
    for (std::size_t row = 0; row < oldest_.size(); ++row) {
      const Worst& oldest = oldest_[row];
      if (oldest.value == kLowest) continue;
      const Ns response = table_.r_minus_in_row(leaf, row);
      const Ns latency =
          oldest.value == 0 ? std::min(response, table_.window_in_row(leaf, row)) : add(oldest.value, response);
      result.offer(latency, oldest.release, oldest.source);
    }
    return result;
  }

 private:
  void offer(std::size_t leaf, Ns t, Ns x) {
    Worst& oldest = oldest_[oldest_.size() > 1 ? table_.row(leaf, t) : 0];
    const Ns age = t - x;
    if (age < oldest.value) return;
    const Ns first = t - round_down(t, repetition_);
    oldest.offer(age, first, first - age);
  }

  const ReleaseTable& table_;
  std::vector<Worst> oldest_;  ///< per row of the table: value is the age
  Ns repetition_ = 1;
};

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
    for (std::size_t i = 0; i < n; ++i) {
      const Ns x = static_cast<Ns>(i) * root_period;
      down[i] = std::max(down[i], add(group.exact->next[i] - group.period - x, most_response));
      up[i] = std::max(up[i], x - group.exact->source[i]);
    }
  }

  Ns worst() {
    Ns result = 0;
    for (const auto& [n, first] : ages_) {
      most_down_ = std::max(most_down_, *std::max_element(first.down.begin(), first.down.end()));
      most_up_ = std::max(most_up_, *std::max_element(first.up.begin(), first.up.end()));
      for (const auto& [m, second] : ages_) result = std::max(result, worst_pair(first.down, second.up));
    }
    return closed_ ? add(most_down_, most_up_) : result;
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
    std::vector<Ns> folded(common, kLowest);
    for (std::size_t i = 0; i < ages.size(); ++i) folded[i % common] = std::max(folded[i % common], ages[i]);
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
            const ReleaseTable& table, std::size_t tree, bool corollaries, Effort& effort)
      : model_(model),
        topology_(topology),
        set_(set),
        responses_(responses),
        table_(table),
        tree_(tree),
        corollaries_(corollaries),
        effort_(effort) {}

  TreeResult find() {
    result_.root = topology_.roots[tree_];
    classify();
    for (const std::size_t leaf : topology_.leaves[tree_]) {
      place_[leaf] = result_.paths.size();
      result_.paths.push_back({leaf, {}, {}, {}, false});
    }
    walk_tree(model_, topology_, responses_, set_, table_, result_.root, effort_,
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
    std::optional<GroupBound> bound;
    if (group.exact != nullptr) bound.emplace(group, table_, root_period, most_response, effort_);
    for (const std::size_t d : group.devices) {
      if (topology_.children[d].empty()) set_path(result_.paths[place_.at(d)], group, bound, d);
    }
    if (corollaries_) cross_.add_group(group, most_response, root_period);
  }

  void set_path(PathResult& path, const HandOverGroup& group, const std::optional<GroupBound>& bound,
                std::size_t leaf) {
    const Ns response = responses_.r_minus[leaf];
    if (!bound) {
      path.closed_form = true;
      path.latency_ns = group.age == 0 ? std::min(response, table_.window(leaf)) : add(group.age, response);
      return;
    }
    const Worst worst = bound->worst(leaf);
    path.latency_ns = worst.value;
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
  Effort& effort_;
  TreeResult result_;
  CrossBound cross_;
  std::map<std::size_t, std::size_t> place_;  ///< leaf -> index into result_.paths
};

}  // namespace

std::vector<TreeResult> bound_latencies(const Model& model, const Topology& topology, const TaskSet& set,
                                        const Responses& responses, const ReleaseTable& table, bool corollaries,
                                        Effort& effort) {
  std::vector<TreeResult> trees;
  for (std::size_t tree = 0; tree < topology.roots.size(); ++tree) {
    trees.push_back(TreeBound(model, topology, set, responses, table, tree, corollaries, effort).find());
  }
  return trees;
}

}  // namespace finemote::gen::timing
