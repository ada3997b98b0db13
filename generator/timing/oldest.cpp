#include "generator/timing/oldest.hpp"

#include <algorithm>

namespace finemote::gen::timing {

void OldestSources::add_group(const HandOverGroup& group, const Oldest& best) {
  if (group.exact == nullptr) return closed_.offer({group.closed.up + best.age, best.source});
  sources_.push_back({group.exact->up, best});
}

/// Every source goes into the whole of the longest repetition its own divides.
void OldestSources::gather() {
  is_gathered_ = true;
  std::stable_sort(sources_.begin(), sources_.end(),
                   [](const Source& a, const Source& b) { return a.up->length > b.up->length; });
  for (const Source& source : sources_) {
    const Staircase& up = *source.up;
    const std::size_t entries = static_cast<std::size_t>(up.root_releases);
    auto whole = std::find_if(wholes_.begin(), wholes_.end(), [&](const List& w) { return w.size() % entries == 0; });
    const std::size_t size = whole == wholes_.end() ? 2 * entries : whole->size() / entries * up.steps.size();
    if (!effort_.spend(static_cast<std::int64_t>(size + wholes_.size()))) {
      closed_.offer({oldest_up(up, root_period_) + source.best.age, source.best.source});
      continue;
    }
    if (whole == wholes_.end()) whole = wholes_.emplace(whole, entries);
    for (std::size_t first = 0; first < whole->size(); first += entries) {
      for (const Staircase::Step& step : up.steps) {
        (*whole)[first + static_cast<std::size_t>(step.root)].offer(
            step.root * root_period_ - step.device + source.best.age, source.best.source);
      }
    }
  }
  for (List& whole : wholes_) {
    spread(whole);
    for (const Oldest& oldest : whole) oldest_.offer(oldest);
  }
}

/// From the ends of steps to all root releases, backward from the oldest: a release uses nothing younger than the next
/// one does.
void OldestSources::spread(List& list) const {
  const auto younger = [](const Oldest& a, const Oldest& b) { return a.age < b.age; };
  auto i = static_cast<std::size_t>(std::max_element(list.begin(), list.end(), younger) - list.begin());
  for (std::size_t count = 1; count < list.size(); ++count) {
    const std::size_t before = i > 0 ? i - 1 : list.size() - 1;
    list[before].offer(list[i].age - root_period_, list[i].source);
    i = before;
  }
}

const OldestSources::List& OldestSources::folded(std::size_t whole, std::size_t common) {
  const List& list = wholes_[whole];
  if (common == list.size()) return list;
  List& result = folded_[{whole, common}];
  if (!result.empty()) return result;
  result.assign(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(common));
  for (std::size_t block = common; block < list.size(); block += common) {
    for (std::size_t i = 0; i < common; ++i) result[i].offer(list[block + i]);
  }
  return result;
}

/// How many root releases are looked at for a terminal.
std::int64_t OldestSources::steps_of_worst(const Staircase& down) const {
  const auto entries = static_cast<std::size_t>(down.root_releases);
  std::size_t steps = down.steps.size();
  for (const List& whole : wholes_) {
    const bool divides = whole.size() % entries == 0;
    steps += divides ? whole.size() / entries * down.steps.size() : down.steps.size() + whole.size();
  }
  return static_cast<std::int64_t>(steps);
}

OldestSources::Oldest OldestSources::worst(const HandOverGroup& group) {
  if (!is_gathered_) gather();
  Oldest worst;
  if (group.exact == nullptr) {
    worst = oldest_;
    worst.offer(closed_);
    return {group.closed.down + worst.age, worst.source};
  }
  const Staircase& down = *group.exact->down;
  if (!effort_.spend(steps_of_worst(down))) {
    gave_up_ = true;
    worst = oldest_;
    worst.offer(closed_);
    return {oldest_down(down, group.period, root_period_) + worst.age, worst.source};
  }
  const std::size_t entries = static_cast<std::size_t>(down.root_releases);
  for (std::size_t w = 0; w < wholes_.size(); ++w) {
    // A repetition that divides the whole is unrolled in steps, which are few; any other one is met where it can be.
    const bool divides = wholes_[w].size() % entries == 0;
    const List& list = divides ? wholes_[w] : folded(w, std::gcd(entries, wholes_[w].size()));
    const std::size_t end = divides ? list.size() : entries;
    for (std::size_t first = 0; first < end; first += entries) {
      for (const Staircase::Step& step : down.steps) {
        const std::size_t place = first + static_cast<std::size_t>(step.root);
        const Oldest& source = list[divides ? place : place % list.size()];
        worst.offer(step.device - group.period - step.root * root_period_ + source.age, source.source);
      }
    }
  }
  for (const Staircase::Step& step : down.steps) {
    worst.offer(step.device - group.period - step.root * root_period_ + closed_.age, closed_.source);
  }
  return worst;
}

}  // namespace finemote::gen::timing
