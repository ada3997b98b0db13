#include "generator/timing/walk.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace finemote::gen::timing {
namespace {

constexpr Ns kMostEntries = 1'000'000;  ///< of one hand-over

/// How long after its release a slower producer's data is there for sure, per row of its release table, in whole
/// multiples of the common divisor of both periods (releases of both only differ by such). Empty: at once, because the
/// producer is not slower.
using Lags = std::vector<Ns>;

bool is_constant(const Lags& lags) {
  return std::all_of(lags.begin(), lags.end(), [&](Ns lag) { return lag == lags.front(); });
}

/// The lag at one release after the other: mostly the same release, or the one after it.
class LagCursor {
 public:
  LagCursor(const Lags& lags, const ReleaseTable& table, std::size_t producer, Ns period)
      : lags_(lags), table_(table), producer_(producer), period_(period), lag_(lags.empty() ? 0 : lags.front()) {}

  Ns at(Ns release) {
    if (lags_.size() > 1 && release != release_) move_to(release);
    return lag_;
  }

 private:
  void move_to(Ns release) {
    if (release - release_ == period_ && release_ != kNone) {
      if (++turn_ == table_.turns(producer_)) turn_ = 0;
    } else {
      turn_ = table_.turn(producer_, release);
    }
    release_ = release;
    lag_ = lags_[table_.row_of_turn(producer_, turn_)];
  }

  const Lags& lags_;
  const ReleaseTable& table_;
  std::size_t producer_;
  Ns period_;
  Ns release_ = kNone;
  std::size_t turn_ = 0;
  Ns lag_;
};

class Walker {
 public:
  Walker(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
         const ReleaseTable& table, HandOverStore& store, Effort& effort)
      : model_(model),
        topology_(topology),
        responses_(responses),
        set_(set),
        table_(table),
        store_(store),
        effort_(effort) {}

  void walk(std::size_t root, const std::function<void(const HandOverGroup&)>& visit) {
    if (!responses_.ok(set_.bucket_of[root])) return;
    root_period_ = model_.devices[root].period_ns;
    std::vector<Pending> stack;
    stack.push_back({{root_period_, {root}, at_root()}, {}, {}, 0, 0});
    while (!stack.empty()) {
      Pending pending = std::move(stack.back());
      stack.pop_back();
      const HandOverGroup group = finish(std::move(pending));
      visit(group);
      push_children(group, stack);
    }
  }

 private:
  /// A group whose hand-over is still that of its parent's group.
  struct Pending {
    HandOverGroup group;
    Lags down, up;           ///< of the parent's handle, and of the group's update
    std::size_t parent = 0;  ///< one of the parents: they share period and row layout
    Ns parent_period = 0;    ///< 0: the root itself
  };

  std::shared_ptr<const HandOver> at_root() {
    HandOverStore::Key key{nullptr, root_period_, {}, {}};
    if (auto known = store_.find(key)) return known;
    HandOver start;
    start.length = root_period_;
    start.next = {root_period_};
    start.source = {0};
    return store_.keep(std::move(key), std::move(start));
  }

  template <typename InRow>
  Lags lags(std::size_t producer, Ns consumer_period, ReleaseTable::Range range, InRow in_row) const {
    const Ns step = std::gcd(model_.devices[producer].period_ns, consumer_period);
    const Ns least = round_up(std::max(range.least, set_.least_lag), step);
    if (round_up(std::max(range.most, set_.least_lag), step) == least) return {least};
    Lags result;
    const Divider by_step(step);
    for (std::size_t row = 0; row < table_.rows(producer); ++row) {
      result.push_back(-by_step.floor(-std::max(in_row(producer, row), set_.least_lag)) * step);
    }
    if (is_constant(result)) result.resize(1);
    return result;
  }

  void push_children(const HandOverGroup& group, std::vector<Pending>& stack) const {
    std::map<std::tuple<Ns, Lags, Lags>, Pending> parts;
    for (const std::size_t parent : group.devices) {
      std::map<Ns, Lags> down_lags;  // per period of the child
      for (const std::size_t child : topology_.children[parent]) {
        if (!responses_.ok(set_.bucket_of[child])) continue;
        const Ns period = model_.devices[child].period_ns;
        Lags down, up;
        if (period < group.period) {
          auto& known = down_lags[period];
          if (known.empty()) {
            known = lags(parent, period, table_.r_minus_range(parent),
                         [&](std::size_t d, std::size_t row) { return table_.r_minus_in_row(d, row); });
          }
          down = known;
        } else if (period > group.period) {
          up = lags(child, group.period, table_.r_plus_range(child),
                    [&](std::size_t d, std::size_t row) { return table_.r_plus_in_row(d, row); });
        }
        auto [entry, fresh] = parts.try_emplace({period, down, up});
        if (fresh) {
          entry->second = {{period, {}, group.exact, group.age, group.down, group.up}, down, up, parent, group.period};
        }
        entry->second.group.devices.push_back(child);
      }
    }
    for (auto& [key, part] : parts) stack.push_back(std::move(part));
  }

  HandOverGroup finish(Pending pending) {
    HandOverGroup& group = pending.group;
    if (pending.parent_period == 0 || pending.parent_period == group.period) return std::move(group);
    if (group.exact != nullptr) {
      HandOverStore::Key key{group.exact.get(), group.period, pending.down, pending.up};
      if (auto known = store_.find(key)) {
        group.exact = std::move(known);
        return std::move(group);
      }
      Ns length = lcm(group.exact->length, group.period);
      if (pending.down.size() > 1) length = lcm(length, table_.repeat(pending.parent));
      if (pending.up.size() > 1) length = lcm(length, table_.repeat(group.devices.front()));
      const Ns entries = length / root_period_;
      if (entries <= kMostEntries && store_.make_room(entries)) {
        group.exact = store_.keep(std::move(key), step(pending, length));
        return std::move(group);
      }
      give_up(pending);
    }
    close(pending);
    return std::move(group);
  }

  HandOver step(const Pending& pending, Ns length) {
    const HandOver& from = *pending.group.exact;
    const Ns period = pending.group.period;
    const std::size_t device = pending.group.devices.front();
    HandOver to;
    to.length = length;
    const auto entries = static_cast<std::size_t>(length / root_period_);
    to.next.reserve(entries);
    to.source.reserve(entries);
    effort_.spend(static_cast<std::int64_t>(4 * entries));
    // Both sequences only grow, so the next multiple is mostly the last one or the one after it.
    Ns next = round_down(from.next.front(), period);
    Ns source = round_down(from.source.front(), period);
    LagCursor down(pending.down, table_, pending.parent, pending.parent_period), up(pending.up, table_, device, period);
    for (Ns shift = 0; shift < length; shift += from.length) {
      for (std::size_t i = 0; i < from.next.size(); ++i) {
        const Ns decision = from.next[i] + shift;
        const Ns seen = decision + down.at(decision);
        if (next < seen) next += period;
        if (next < seen) next = round_up(seen, period);
        to.next.push_back(next);
        const Ns use = from.source[i] + shift;
        if (use - source >= period) source += period;
        if (use - source >= period) source = round_down(use, period);
        const bool too_young = source + up.at(source) > use;
        to.source.push_back(too_young ? source - period : source);
      }
    }
    return to;
  }

  /// From exact entries to the bounds a closed form continues from.
  void give_up(Pending& pending) const {
    HandOverGroup& group = pending.group;
    group.age = group.down = group.up = 0;
    for (std::size_t i = 0; i < group.exact->next.size(); ++i) {
      const Ns x = static_cast<Ns>(i) * root_period_;
      const Ns last = group.exact->next[i] - pending.parent_period;
      group.age = std::max(group.age, last - group.exact->source[i]);
      group.down = std::max(group.down, last - x);
      group.up = std::max(group.up, x - group.exact->source[i]);
    }
    group.exact = nullptr;
  }

  /// One edge further: data handed over is at most T_producer - g + lag old at the consumer's release.
  static void close(Pending& pending) {
    HandOverGroup& group = pending.group;
    const Ns step = std::gcd(group.period, pending.parent_period);
    const auto worst = [](const Lags& lags) { return lags.empty() ? 0 : *std::max_element(lags.begin(), lags.end()); };
    const Ns down = add(pending.parent_period - step, worst(pending.down));
    const Ns up = add(group.period - step, worst(pending.up));
    group.down = add(group.down, down);
    group.up = add(group.up, up);
    group.age = add(group.age, add(down, up));
  }

  const Model& model_;
  const Topology& topology_;
  const Responses& responses_;
  const TaskSet& set_;
  const ReleaseTable& table_;
  HandOverStore& store_;
  Effort& effort_;
  Ns root_period_ = 1;
};

}  // namespace

std::shared_ptr<const HandOver> HandOverStore::find(const Key& key) const {
  const auto found = known_.find(key);
  return found == known_.end() ? nullptr : found->second;
}

bool HandOverStore::make_room(Ns entries) {
  if (*live_ + entries > kMostLive) known_.clear(), held_.clear(), kept_ = 0;
  return *live_ + entries <= kMostLive;
}

std::shared_ptr<const HandOver> HandOverStore::keep(Key key, HandOver value) {
  const auto entries = static_cast<Ns>(value.next.size());
  *live_ += entries;
  std::shared_ptr<const HandOver> shared(new HandOver(std::move(value)), [live = live_, entries](const HandOver* h) {
    *live -= entries;
    delete h;
  });
  if (kept_ + entries > kMostKept) known_.clear(), held_.clear(), kept_ = 0;
  // A key that names a hand-over the store does not hold could outlive it: such a path is not kept.
  const bool is_held = key.above == nullptr || held_.contains(key.above);
  if (!is_held || entries > kMostKept) return shared;
  kept_ += entries;
  held_.insert(shared.get());
  known_.emplace(std::move(key), shared);
  return shared;
}

void walk_tree(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
               const ReleaseTable& table, std::size_t root, HandOverStore& store, Effort& effort,
               const std::function<void(const HandOverGroup&)>& visit) {
  Walker(model, topology, responses, set, table, store, effort).walk(root, visit);
}

}  // namespace finemote::gen::timing
