#include "generator/timing/latency.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen::timing {
namespace {

/// Below every age, also below the negative ones of root releases no terminal uses; two of them add without overflow.
constexpr Ns kLowest = std::numeric_limits<Ns>::min() / 2;

/// The worst terminal release found so far; of equally bad ones the first in [0, repetition).
struct Worst {
  Ns value = kNone;
  Ns release = 0;
  Ns source = 0;

  void offer(Ns new_value, Ns t, Ns x, Ns repetition) {
    if (new_value < value) return;
    const Ns first = t - round_down(t, repetition);
    if (new_value == value && first >= release) return;
    *this = {new_value, first, x - (t - first)};
  }
};

/// Path latency of one leaf, from the hand-over of its group.
class PathBound {
 public:
  PathBound(const HandOver& over, const ReleaseTable& table, std::size_t leaf, Ns period, Ns root_period)
      : over_(over), table_(table), leaf_(leaf), period_(period), root_period_(root_period) {}

  Worst find(Ns most_response, Effort& effort) {
    repetition_ = table_.rows(leaf_) > 1 ? lcm(over_.length, table_.repeat(leaf_)) : over_.length;
    const auto entries = static_cast<Ns>(over_.next.size());
    effort.spend(repetition_ / root_period_);
    for (Ns shift = 0; shift < repetition_; shift += over_.length) {
      for (Ns i = 0; i < entries; ++i) {
        const Ns t = next(i) - period_;
        const Ns age = t - over_.source[static_cast<std::size_t>(i)];
        if (age + most_response < worst_.value) continue;
        offer(t + shift, t + shift - age);
        // An immediate end can tie with the release before it, if that one takes its whole period.
        if (table_.r_minus(leaf_, t + shift) == 0 && next(i - 1) <= t - period_)
          offer(t + shift - period_, t + shift - age);
      }
    }
    return worst_;
  }

 private:
  [[nodiscard]] Ns next(Ns i) const {
    if (i < 0) return over_.next.back() - over_.length;
    return over_.next[static_cast<std::size_t>(i)];
  }

  void offer(Ns t, Ns x) {
    const Ns response = table_.r_minus(leaf_, t);
    const Ns value = t == x ? std::min(response, table_.window(leaf_, t)) : add(t - x, response);
    worst_.offer(value, t, x, repetition_);
  }

  const HandOver& over_;
  const ReleaseTable& table_;
  std::size_t leaf_;
  Ns period_, root_period_;
  Ns repetition_ = 1;
  Worst worst_;
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
    Ns most_response = 0;
    bool has_leaf = false;
    for (const std::size_t d : group.devices) {
      if (!topology_.children[d].empty()) continue;
      has_leaf = true;
      most_response = std::max(most_response, responses_.r_minus[d]);
      set_path(result_.paths[place_.at(d)], group, d, root_period);
    }
    if (has_leaf && corollaries_) cross_.add_group(group, most_response, root_period);
  }

  void set_path(PathResult& path, const HandOverGroup& group, std::size_t leaf, Ns root_period) {
    const Ns response = responses_.r_minus[leaf];
    if (group.exact == nullptr) {
      path.closed_form = true;
      path.latency_ns = group.age == 0 ? std::min(response, table_.window(leaf)) : add(group.age, response);
      return;
    }
    const Worst worst = PathBound(*group.exact, table_, leaf, group.period, root_period).find(response, effort_);
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
