#include "generator/timing/walk.hpp"

#include <algorithm>
#include <set>

#include "generator/units/hyperperiod.hpp"

namespace finemote::gen::timing {
namespace {

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

  void walk(Rank root, const std::function<void(const HandOverGroup&)>& visit) {
    if (!responses_.ok(set_.bucket_of[root])) return;
    if (const auto* known = store_.walked(root)) {
      std::for_each(known->begin(), known->end(), visit);
      return;
    }
    root_period_ = model_.devices[root].period;
    store_.begin_tree();
    std::vector<Pending> stack;
    stack.push_back({{root_period_, {root}, at_root(), {}}, nullptr, nullptr, {}, {}});
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
    const Lags *down, *up;   ///< of the parent's handle, and of the group's update; null at the root
    Rank parent;             ///< one of the parents: they share period and row layout
    Duration parent_period;  ///< 0: the root itself
  };

  std::shared_ptr<const HandOver> at_root() {
    auto& down = store_.down[{nullptr, {}, root_period_, {}}];
    auto& up = store_.up[{nullptr, {}, root_period_, {}}];
    if (down == nullptr) down = store_.keep({root_period_, 1, {{0, root_period_}}});
    if (up == nullptr) up = store_.keep({root_period_, 1, {{0, {}}}});
    return joined({root_period_, down, up}, root_period_);
  }

  std::shared_ptr<const HandOver> joined(const HandOverStore::Ends& ends, Duration length) {
    auto& known = store_.pairs[ends];
    if (known == nullptr) known = std::make_shared<HandOver>(HandOver{length, ends.down, ends.up});
    return known;
  }

  /// A child on its way into a group: what decides which, and whose it is.
  struct Child {
    Duration period = nanoseconds(1);
    const Lags *down, *up;  ///< equal ones are the same
    Rank parent, device;
    [[nodiscard]] bool joins(const Child& other) const {
      return period == other.period && down == other.down && up == other.up;
    }
    friend bool operator<(const Child& a, const Child& b) {
      if (a.period != b.period) return a.period < b.period;
      if (a.down != b.down) return *a.down < *b.down;
      if (a.up != b.up) return *a.up < *b.up;
      return std::tie(a.parent, a.device) < std::tie(b.parent, b.device);
    }
  };

  void push_children(const HandOverGroup& group, std::vector<Pending>& stack) {
    children_.clear();
    for (const Rank parent : group.devices) {
      for (const Rank child : topology_.children[parent]) {
        if (responses_.ok(set_.bucket_of[child])) children_.push_back(child_of(parent, child, group.period));
      }
    }
    if (children_.size() > 1) std::sort(children_.begin(), children_.end());
    for (std::size_t i = 0; i < children_.size();) {
      const Child& first = children_[i];
      Pending part{{first.period, {}, group.exact, group.closed}, first.down, first.up, first.parent, group.period};
      for (; i < children_.size() && children_[i].joins(first); ++i) part.group.devices.push_back(children_[i].device);
      stack.push_back(std::move(part));
    }
  }

  [[nodiscard]] Child child_of(Rank parent, Rank device, Duration parent_period) {
    const Lags* const at_once = &*lags_.insert(Lags{}).first;
    Child child{model_.devices[device].period, at_once, at_once, parent, device};
    if (child.period < parent_period) {
      const Lags*& down = downs_[{parent, child.period}];
      if (down == nullptr) down = one_of(lags_down(set_, table_, parent, child.period, effort_));
      child.down = down;
    } else if (child.period > parent_period) {
      child.up = one_of(lags_up(set_, table_, device, parent_period, effort_));
    }
    return child;
  }

  const Lags* one_of(Lags lags) { return &*lags_.insert(std::move(lags)).first; }

  HandOverGroup finish(Pending pending) {
    HandOverGroup& group = pending.group;
    if (pending.parent_period == Duration::zero() || pending.parent_period == group.period) return std::move(group);
    if (group.exact != nullptr) {
      if (auto below = one_edge_further(pending)) {
        group.exact = std::move(below);
        return std::move(group);
      }
      group.closed = store_.closed_form(group.exact, pending.parent_period, root_period_);
      group.exact = nullptr;
    }
    group.closed = one_edge_below(group.closed, pending.parent_period, group.period, *pending.down, *pending.up);
    return std::move(group);
  }

  /// The hand-over of the group; null where it is beyond the limits.
  std::shared_ptr<const HandOver> one_edge_further(const Pending& pending) {
    const std::shared_ptr<const HandOver>& above = pending.group.exact;
    const Duration period = pending.group.period, parent_period = pending.parent_period;
    const Rank parent = pending.parent, device = pending.group.devices.front();
    const auto down_length = length_below(above->down->length, period, *pending.down, parent);
    const auto up_length = length_below(above->up->length, period, *pending.up, device);
    const auto length = common_multiple(down_length, up_length);
    if (!length || floor_div(*length, root_period_) > effort_.most_releases()) return nullptr;
    const std::int64_t down_steps = steps_in(*above->down, *down_length), up_steps = steps_in(*above->up, *up_length);
    if (!store_.make_room(down_steps + up_steps)) return nullptr;
    auto& down = store_.down[{above->down, parent_period, period, *pending.down}];
    if (down == nullptr) {
      if (!effort_.spend(2 * down_steps)) return nullptr;
      const LagCursor lag(*pending.down, table_, parent, parent_period);
      down = store_.keep(step_down(*above->down, *down_length, period, lag));
    }
    auto& up = store_.up[{above->up, parent_period, period, *pending.up}];
    if (up == nullptr) {
      if (!effort_.spend(2 * up_steps)) return nullptr;
      up = store_.keep(step_up(*above->up, *up_length, period, LagCursor(*pending.up, table_, device, period)));
    }
    return joined({period, down, up}, *length);
  }

  std::optional<Duration> length_below(Duration length, Duration period, const Lags& lags, Rank producer) const {
    const auto common = common_multiple(length, period);
    return lags.per_row.empty() ? common : common_multiple(common, table_.repeat(producer));
  }

  const Model& model_;
  const Topology& topology_;
  const Responses& responses_;
  const TaskSet& set_;
  const ReleaseTable& table_;
  HandOverStore& store_;
  Effort& effort_;
  Duration root_period_ = nanoseconds(1);
  std::vector<Child> children_;                             ///< of the group that was visited last
  std::set<Lags> lags_;                                     ///< all there are in the tree
  std::map<std::pair<Rank, Duration>, const Lags*> downs_;  ///< by producer and period of the consumer
};

}  // namespace

void walk_tree(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
               const ReleaseTable& table, Rank root, HandOverStore& store, Effort& effort,
               const std::function<void(const HandOverGroup&)>& visit) {
  Walker(model, topology, responses, set, table, store, effort).walk(root, visit);
}

}  // namespace finemote::gen::timing
