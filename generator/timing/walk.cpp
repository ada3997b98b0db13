#include "generator/timing/walk.hpp"

#include <algorithm>

namespace finemote::gen::timing {
namespace {

constexpr Ns kMostEntries = 1'000'000;  ///< root releases in one repetition of a hand-over
constexpr Ns kLongAgo = std::numeric_limits<Ns>::min();

/// The lag at one release after the other: mostly the same release, or the one after it.
class LagCursor {
 public:
  LagCursor(const Lags& lags, const ReleaseTable& table, std::size_t producer, Ns period)
      : lags_(lags), table_(table), producer_(producer), period_(period), lag_(lags.most) {}

  Ns at(Ns release) {
    if (!lags_.per_row.empty() && release != release_) move_to(release);
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
    lag_ = lags_.per_row[table_.row_of_turn(producer_, turn_)];
  }

  const Lags& lags_;
  const ReleaseTable& table_;
  std::size_t producer_;
  Ns period_;
  Ns release_ = kNone;
  std::size_t turn_ = 0;
  Ns lag_;
};

/// Adds to a number as long as it lives.
class Counted {
 public:
  Counted(std::shared_ptr<Ns> total, Ns count) : total_(std::move(total)), count_(count) { *total_ += count_; }
  ~Counted() { *total_ -= count_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  std::shared_ptr<Ns> total_;
  Ns count_;
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
    if (const auto* known = store_.walked(root)) {
      std::for_each(known->begin(), known->end(), visit);
      return;
    }
    root_period_ = model_.devices[root].period_ns;
    store_.begin_tree();
    std::vector<Pending> stack;
    stack.push_back({{root_period_, {root}, at_root()}, {}, {}, 0, 0});
    while (!stack.empty()) {
      Pending pending = std::move(stack.back());
      stack.pop_back();
      HandOverGroup group = finish(std::move(pending));
      visit(group);
      push_children(group, stack);
      store_.add(std::move(group));
    }
    store_.end_tree(root);
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
    auto& down = store_.down[{nullptr, 0, root_period_, {}}];
    auto& up = store_.up[{nullptr, 0, root_period_, {}}];
    if (down == nullptr) down = store_.keep({root_period_, 1, {{0, root_period_}}});
    if (up == nullptr) up = store_.keep({root_period_, 1, {{0, 0}}});
    return joined({root_period_, down, up}, root_period_);
  }

  std::shared_ptr<const HandOver> joined(const HandOverStore::Ends& ends, Ns length) {
    auto& known = store_.pairs[ends];
    if (known == nullptr) known = std::make_shared<HandOver>(HandOver{length, ends.down, ends.up, {}});
    return known;
  }

  template <typename InRow>
  Lags lags(std::size_t producer, Ns consumer_period, ReleaseTable::Range range, InRow in_row) const {
    const Ns step = std::gcd(model_.devices[producer].period_ns, consumer_period);
    Lags result;
    result.most = round_up(std::max(range.most, set_.least_lag), step);
    if (round_up(std::max(range.least, set_.least_lag), step) == result.most) return result;
    const std::size_t rows = table_.rows(producer);
    result.per_row.reserve(rows);
    const Divider by_step(step);
    for (std::size_t row = 0; row < rows; ++row) {
      result.per_row.push_back(-by_step.floor(-std::max(in_row(producer, row), set_.least_lag)) * step);
    }
    return result;
  }

  /// A child on its way into a group: what decides which, and whose it is.
  struct Child {
    Ns period = 1;
    Lags down, up;
    std::size_t parent = 0, device = 0;
    [[nodiscard]] bool joins(const Child& other) const {
      return period == other.period && down == other.down && up == other.up;
    }
    friend auto operator<=>(const Child&, const Child&) = default;
  };

  void push_children(const HandOverGroup& group, std::vector<Pending>& stack) {
    children_.clear();
    for (const std::size_t parent : group.devices) {
      for (const std::size_t child : topology_.children[parent]) {
        if (responses_.ok(set_.bucket_of[child])) children_.push_back(child_of(parent, child, group.period));
      }
    }
    if (children_.size() > 1) std::sort(children_.begin(), children_.end());
    for (std::size_t i = 0; i < children_.size();) {
      Child& first = children_[i];
      Pending part{
          {first.period, {}, group.exact, group.age, group.down, group.up}, {}, {}, first.parent, group.period};
      for (; i < children_.size() && children_[i].joins(first); ++i) part.group.devices.push_back(children_[i].device);
      part.down = std::move(first.down);
      part.up = std::move(first.up);
      stack.push_back(std::move(part));
    }
  }

  [[nodiscard]] Child child_of(std::size_t parent, std::size_t device, Ns parent_period) const {
    Child child{model_.devices[device].period_ns, {}, {}, parent, device};
    if (child.period < parent_period) {
      child.down = lags(parent, child.period, table_.r_minus_range(parent),
                        [&](std::size_t d, std::size_t row) { return table_.r_minus_in_row(d, row); });
    } else if (child.period > parent_period) {
      child.up = lags(device, parent_period, table_.r_plus_range(device),
                      [&](std::size_t d, std::size_t row) { return table_.r_plus_in_row(d, row); });
    }
    return child;
  }

  HandOverGroup finish(Pending pending) {
    HandOverGroup& group = pending.group;
    if (pending.parent_period == 0 || pending.parent_period == group.period) return std::move(group);
    if (group.exact != nullptr) {
      if (auto below = step(pending)) {
        group.exact = std::move(below);
        return std::move(group);
      }
      give_up(pending);
    }
    close(pending);
    return std::move(group);
  }

  /// The hand-over of the group; null where it repeats too late.
  std::shared_ptr<const HandOver> step(const Pending& pending) {
    const std::shared_ptr<const HandOver>& above = pending.group.exact;
    const Ns period = pending.group.period;
    const Ns down_length = length_below(above->down->length, period, pending.down, pending.parent);
    const Ns up_length = length_below(above->up->length, period, pending.up, pending.group.devices.front());
    const Ns length = lcm(down_length, up_length);
    if (length / root_period_ > kMostEntries) return nullptr;
    const Ns steps = steps_below(*above->down, down_length) + steps_below(*above->up, up_length);
    if (!store_.make_room(steps)) return nullptr;
    auto& down = store_.down[{above->down, pending.parent_period, period, pending.down}];
    if (down == nullptr) down = store_.keep(step_down(*above->down, down_length, pending));
    auto& up = store_.up[{above->up, pending.parent_period, period, pending.up}];
    if (up == nullptr) up = store_.keep(step_up(*above->up, up_length, pending));
    return joined({period, down, up}, length);
  }

  Ns length_below(Ns length, Ns period, const Lags& lags, std::size_t producer) const {
    const Ns common = lcm(length, period);
    return lags.per_row.empty() ? common : lcm(common, table_.repeat(producer));
  }

  static Ns steps_below(const Staircase& from, Ns length) {
    return static_cast<Ns>(from.steps.size()) * (length / from.length);
  }

  // Which step goes on and which one begins is different every time: no branches in these loops.

  Staircase step_down(const Staircase& from, Ns length, const Pending& pending) {
    const Ns period = pending.group.period;
    Staircase::Step* last = start_steps(from, length);
    LagCursor lag(pending.down, table_, pending.parent, pending.parent_period);
    const Divider by_period(period);
    Ns root_shift = 0;
    for (Ns shift = 0; shift < length; shift += from.length, root_shift += from.root_releases) {
      for (const Staircase::Step& step : from.steps) {
        const Ns decided = step.device + shift;
        const Ns seen = -by_period.floor(-(decided + lag.at(decided))) * period;
        last[1] = {step.root + root_shift, seen};  // and forgotten where the step before has led there already
        last += seen > last->device ? 1 : 0;
      }
    }
    Staircase::Step* first = steps_.data() + 1;
    // The first step may only go on with the last one of the repetition before.
    if (first->device == last->device - length) ++first;
    return {length, length / root_period_, {first, last + 1}};
  }

  Staircase step_up(const Staircase& from, Ns length, const Pending& pending) {
    const Ns period = pending.group.period;
    Staircase::Step* last = start_steps(from, length);
    LagCursor lag(pending.up, table_, pending.group.devices.front(), period);
    const Divider by_period(period);
    Ns root_shift = 0;
    for (Ns shift = 0; shift < length; shift += from.length, root_shift += from.root_releases) {
      for (const Staircase::Step& step : from.steps) {
        const Ns use = step.device + shift;
        const Ns release = by_period.floor(use) * period;
        const Ns source = release + lag.at(release) > use ? release - period : release;  // not there yet
        last += source != last->device ? 1 : 0;
        *last = {step.root + root_shift, source};
      }
    }
    const Staircase::Step* first = steps_.data() + 1;
    // The last step may go on into the next repetition, where it is the first one.
    if (last->device == first->device + length) --last;
    return {length, length / root_period_, {first, const_cast<const Staircase::Step*>(last) + 1}};
  }

  /// Room for as many steps as there can be, behind one that is none.
  Staircase::Step* start_steps(const Staircase& from, Ns length) {
    const Ns most = steps_below(from, length);
    effort_.spend(2 * most);
    if (steps_.size() < static_cast<std::size_t>(most) + 2) steps_.resize(static_cast<std::size_t>(most) + 2);
    steps_.front() = {0, kLongAgo};
    return steps_.data();
  }

  /// From exact staircases to the bounds a closed form continues from.
  void give_up(Pending& pending) const {
    HandOverGroup& group = pending.group;
    const HandOver& over = *group.exact;
    group.age = group.down = group.up = 0;
    group.age = std::max(group.age, add(oldest_age(join(*over.down, *over.up, over.length)), -pending.parent_period));
    for (const Staircase::Step& step : over.down->steps) {
      group.down = std::max(group.down, step.device - pending.parent_period - step.root * root_period_);
    }
    for (const Staircase::Step& step : over.up->steps)
      group.up = std::max(group.up, step.root * root_period_ - step.device);
    group.exact = nullptr;
  }

  /// One edge further: data handed over is at most T_producer - g + lag old at the consumer's release.
  static void close(Pending& pending) {
    HandOverGroup& group = pending.group;
    const Ns step = std::gcd(group.period, pending.parent_period);
    const Ns down = add(pending.parent_period - step, pending.down.most);
    const Ns up = add(group.period - step, pending.up.most);
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
  std::vector<Staircase::Step> steps_;  ///< of the staircase that is being made
  std::vector<Child> children_;         ///< of the group that was visited last
};

}  // namespace

std::vector<TerminalUse> join(const Staircase& down, const Staircase& up, Ns length) {
  const std::size_t down_size = down.steps.size();
  const auto repetitions = static_cast<std::size_t>(length / down.length);
  std::vector<TerminalUse> uses(down_size * repetitions + 1);
  TerminalUse* use = uses.data();
  Ns up_shift = 0, up_root_shift = 0, root_shift = 0;
  const Staircase::Step* source = up.steps.data();
  const Staircase::Step* const up_end = source + up.steps.size();
  for (Ns shift = 0; shift < length; shift += down.length, root_shift += down.root_releases) {
    const Staircase::Step* step = down.steps.data();
    const Staircase::Step* const end = step + down_size;
    while (step != end) {
      // Either this use has found its source, or the source is too old: one of both goes on, without a branch.
      *use = {step->device + shift, source->device + up_shift};
      const bool is_too_old = source->root + up_root_shift < step->root + root_shift;
      source += is_too_old ? 1 : 0;
      step += is_too_old ? 0 : 1;
      use += is_too_old ? 0 : 1;
      if (source == up_end) {
        source = up.steps.data();
        up_shift += up.length;
        up_root_shift += up.root_releases;
      }
    }
  }
  uses.pop_back();
  return uses;
}

Ns oldest_age(const std::vector<TerminalUse>& uses) {
  Ns oldest = std::numeric_limits<Ns>::min();
  for (const TerminalUse& use : uses) oldest = std::max(oldest, use.next - use.source);
  return oldest;
}

std::size_t HandOverStore::Hash::operator()(const Edge& edge) const {
  std::uint64_t hash = reinterpret_cast<std::uintptr_t>(edge.above.get());
  mix(hash, edge.above_period);
  mix(hash, edge.period);
  mix(hash, edge.lags.most);
  for (const Ns lag : edge.lags.per_row) mix(hash, lag);
  return hash;
}

std::size_t HandOverStore::Hash::operator()(const Ends& ends) const {
  std::uint64_t hash = reinterpret_cast<std::uintptr_t>(ends.down.get());
  mix(hash, static_cast<Ns>(reinterpret_cast<std::uintptr_t>(ends.up.get())));
  mix(hash, ends.period);
  return hash;
}

std::size_t HandOverStore::Hash::operator()(const std::shared_ptr<const Staircase>& stairs) const {
  auto hash = static_cast<std::uint64_t>(stairs->length);
  for (const Staircase::Step& step : stairs->steps) mix(hash, step.root), mix(hash, step.device);
  return hash;
}

std::shared_ptr<const Staircase> HandOverStore::keep(Staircase stairs) {
  struct Kept {
    Staircase stairs;
    Counted counted;
    Kept(Staircase s, const std::shared_ptr<Ns>& live)
        : stairs(std::move(s)), counted(live, static_cast<Ns>(stairs.steps.size())) {}
  };
  const bool is_small = stairs.steps.size() <= kSmall;
  const auto kept = std::make_shared<const Kept>(std::move(stairs), live_);
  std::shared_ptr<const Staircase> result(kept, &kept->stairs);
  return is_small ? *small_.insert(std::move(result)).first : result;
}

bool HandOverStore::make_room(Ns steps) {
  if (*live_ + steps > kMostLive) forget();
  return *live_ + steps <= kMostLive;
}

void HandOverStore::forget() {
  down.clear();
  up.clear();
  pairs.clear();
  small_.clear();
  walked_.clear();
  tree_.clear();
  is_whole_ = false;
}

const std::vector<HandOverGroup>* HandOverStore::walked(std::size_t root) const {
  const auto found = walked_.find(root);
  return found == walked_.end() ? nullptr : &found->second;
}

void HandOverStore::add(HandOverGroup group) {
  if (is_whole_) tree_.push_back(std::move(group));
}

void HandOverStore::end_tree(std::size_t root) {
  if (is_whole_) walked_[root] = std::move(tree_);
  tree_.clear();
}

void walk_tree(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
               const ReleaseTable& table, std::size_t root, HandOverStore& store, Effort& effort,
               const std::function<void(const HandOverGroup&)>& visit) {
  Walker(model, topology, responses, set, table, store, effort).walk(root, visit);
}

}  // namespace finemote::gen::timing
