#include "generator/timing/hand_over_store.hpp"

namespace finemote::gen::timing {
namespace {

/// Adds to a number as long as it lives.
class Counted {
 public:
  Counted(std::shared_ptr<std::int64_t> total, std::int64_t count) : total_(std::move(total)), count_(count) {
    *total_ += count_;
  }
  ~Counted() { *total_ -= count_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  std::shared_ptr<std::int64_t> total_;
  std::int64_t count_;
};

}  // namespace

std::size_t HandOverStore::Hash::operator()(const Edge& edge) const {
  std::uint64_t hash = reinterpret_cast<std::uintptr_t>(edge.above.get());
  mix(hash, edge.above_period.ns());
  mix(hash, edge.period.ns());
  mix(hash, edge.lags.most.ns());
  for (const Duration lag : edge.lags.per_row) mix(hash, lag.ns());
  return hash;
}

std::size_t HandOverStore::Hash::operator()(const Ends& ends) const {
  std::uint64_t hash = reinterpret_cast<std::uintptr_t>(ends.down.get());
  mix(hash, static_cast<std::int64_t>(reinterpret_cast<std::uintptr_t>(ends.up.get())));
  mix(hash, ends.period.ns());
  return hash;
}

std::size_t HandOverStore::Hash::operator()(const std::shared_ptr<const Staircase>& stairs) const {
  auto hash = static_cast<std::uint64_t>(stairs->length.ns());
  for (const Staircase::Step& step : stairs->steps) mix(hash, step.root), mix(hash, step.device.ns());
  return hash;
}

std::shared_ptr<const Staircase> HandOverStore::keep(Staircase stairs) {
  struct Kept {
    Staircase stairs;
    Counted counted;
    Kept(Staircase s, const std::shared_ptr<std::int64_t>& live)
        : stairs(std::move(s)), counted(live, static_cast<std::int64_t>(stairs.steps.size())) {}
  };
  const bool is_small = stairs.steps.size() <= kSmall;
  const auto kept = std::make_shared<const Kept>(std::move(stairs), live_);
  std::shared_ptr<const Staircase> result(kept, &kept->stairs);
  return is_small ? *small_.insert(std::move(result)).first : result;
}

ClosedForm HandOverStore::closed_form(const std::shared_ptr<const HandOver>& exact, Duration period,
                                      Duration root_period) {
  const auto [entry, fresh] = closed_forms_.try_emplace(exact);
  if (fresh) entry->second = closed_form_of(*exact, period, root_period);
  return entry->second;
}

bool HandOverStore::make_room(std::int64_t steps) {
  if (*live_ + steps > kMostLive) forget();
  return *live_ + steps <= kMostLive;
}

void HandOverStore::forget() {
  down.clear();
  up.clear();
  pairs.clear();
  oldest_uses.clear();
  closed_forms_.clear();
  small_.clear();
  walked_.clear();
  tree_.clear();
  is_whole_ = false;
}

const std::vector<HandOverGroup>* HandOverStore::walked(Rank root) const {
  const auto found = walked_.find(root);
  return found == walked_.end() ? nullptr : &found->second;
}

void HandOverStore::add(HandOverGroup group) {
  if (is_whole_) tree_.push_back(std::move(group));
}

void HandOverStore::end_tree(Rank root) {
  if (is_whole_) walked_[root] = std::move(tree_);
  tree_.clear();
}

}  // namespace finemote::gen::timing
