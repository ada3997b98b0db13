#include "generator/timing/decision.hpp"

#include <algorithm>
#include <map>

namespace finemote::gen::timing {
namespace {

constexpr Ns kMostEntries = 1'000'000;

}  // namespace

/// The devices of a chain: down from the root to the terminal, and everything between the source and the root.
struct DecisionAnalysis::Route {
  Rank from, to;
  std::vector<Rank> down;                           ///< root first, terminal last
  std::vector<Rank> up;                             ///< root first, source last; every producer after its consumers
  std::vector<std::vector<std::size_t>> consumers;  ///< per entry of `up`: places in `up`
  bool through_reads = false;
};

DecisionAnalysis::DecisionAnalysis(const Model& model, const Topology& topology, const Reach& reach,
                                   const ProfileAnalysis& profile, Effort& effort)
    : model_(model),
      topology_(topology),
      reach_(reach),
      profile_(profile),
      effort_(effort),
      updates_from_(model.devices.size()),
      handles_from_(model.devices.size()) {
  find_hand_overs();
  for (const TaskBucket& bucket : profile.set.buckets) {
    Ns updates = 0, handles = 0;
    for (auto d = bucket.devices.rbegin(); d != bucket.devices.rend(); ++d) {
      updates_from_[*d] = updates = add(updates, profile.set.update[*d]);
      handles_from_[*d] = handles = add(handles, profile.set.handle[*d]);
    }
  }
}

/// Of every device of a tree that was walked, unless closed forms stand in, and unless other ways lead through reads.
void DecisionAnalysis::find_hand_overs() {
  hand_over_.resize(model_.devices.size());
  for (const Rank root : topology_.roots) {
    const auto* groups = reach_.reads_in_tree_of(root) ? nullptr : profile_.hand_overs->walked(root);
    if (groups == nullptr) continue;
    for (const HandOverGroup& group : *groups) {
      for (const Rank d : group.devices) hand_over_[d] = group.exact;
    }
  }
}

DecisionAnalysis::Route DecisionAnalysis::route(Rank from, Rank to) const {
  Route r{from, to, {to}, {}, {}, false};
  while (model_.devices[r.down.back()].parent) r.down.push_back(*model_.devices[r.down.back()].parent);
  std::reverse(r.down.begin(), r.down.end());
  const Rank root = r.down.front();
  // Depth first from the source; a device is finished after all its consumers, and kept when the root is above it.
  std::map<Rank, bool> reaches;
  std::vector<std::pair<Rank, std::size_t>> stack{{from, 0}};
  while (!stack.empty()) {
    auto& [device, next] = stack.back();
    if (device == root || next == reach_.consumers(device).size()) {
      bool good = device == root;
      for (const Rank c : reach_.consumers(device)) good |= device != root && reaches[c];
      reaches[device] = good;
      if (good) r.up.push_back(device);
      stack.pop_back();
      continue;
    }
    const Rank consumer = reach_.consumers(device)[next++];
    if (!reaches.contains(consumer)) stack.emplace_back(consumer, 0);
  }
  std::map<Rank, std::size_t> place;
  for (const Rank device : r.up) {
    auto& list = r.consumers.emplace_back();
    for (const Rank c : reach_.consumers(device)) {
      if (device == root || !place.contains(c)) continue;
      list.push_back(place[c]);
      r.through_reads |= model_.devices[device].parent != c;
    }
    place[device] = r.consumers.size() - 1;
  }
  return r;
}

/// First release of `consumer` whose handle() sees what the release of `producer` decided.
Ns DecisionAnalysis::hand_down(Ns release, Rank producer, Rank consumer) const {
  const Ns period = model_.devices[consumer].period_ns;
  Ns ready = release;
  if (model_.devices[producer].period_ns > period) {
    ready = add(ready, std::max(profile_.table.r_minus(producer, release), profile_.set.least_lag));
  }
  return round_up(ready, period);
}

/// Release of `producer` whose state the release of `consumer` uses at `use`, or an older one.
Ns DecisionAnalysis::used(Ns use, Rank producer, Rank consumer) const {
  const Ns period = model_.devices[producer].period_ns;
  const Ns release = round_down(use, period);
  if (period == model_.devices[consumer].period_ns) return producer < consumer ? release : release - period;
  if (period < model_.devices[consumer].period_ns) return release;
  const Ns ready = add(release, std::max(profile_.table.r_plus(producer, release), profile_.set.least_lag));
  return ready > use ? release - period : release;
}

/// Begin of update(from) to end of handle(to) in one job: W of analysis-cases/README.md for two devices of a bucket.
Ns DecisionAnalysis::pair_window(Rank from, Rank to, Ns release) const {
  const TaskSet& set = profile_.set;
  const std::size_t w = set.bucket_of[to];
  const Ns response = profile_.table.r_minus(to, release);
  const Ns extra = set.handle[to] == 0 ? 1 : 0;
  Ns work = extra;
  work = add(work, add(updates_from_[from], handles_from_[to]));
  Demand demand(effort_);
  demand.add_streams(set.streams);
  const Ns length = response - 1 + extra;
  const bool is_any_release = profile_.table.is_general(w);  // as many as fit, wherever the release is
  for (std::size_t v = 0; v < w; ++v) {
    const Ns period = set.buckets[v].period;
    const Ns inside =
        is_any_release ? ceil_div(length, period) : floor_div(release + length, period) - floor_div(release, period);
    demand.add({0, period, set.buckets[v].cost, inside});
  }
  return std::min(least_fit(demand, work, std::max<Ns>(work, 1), kNever - 1) - extra, response);
}

/// The same maximum from what the latency analysis walked; kNone where it repeats too late.
Ns DecisionAnalysis::join_hand_overs(Rank from, Rank to) const {
  const Staircase &down = *hand_over_[to]->down, &up = *hand_over_[from]->up;
  const ReleaseTable& table = profile_.table;
  const Ns length = lcm(down.length, up.length);
  const Ns repetition = table.rows(to) > 1 ? lcm(length, table.repeat(to)) : length;
  if (repetition / model_.devices[topology_.root_of[to]].period_ns > kMostEntries) return kNone;
  const Ns period = model_.devices[to].period_ns;
  const bool one_bucket = profile_.set.bucket_of[from] == profile_.set.bucket_of[to];
  const Ns most = table.r_minus_range(to).most;
  std::vector<bool> seen(table.rows(to));  // releases in one row have one window
  Ns worst = 0;
  const std::vector<TerminalUse> uses = join(down, up, length);
  effort_.spend(add(static_cast<Ns>(uses.size()), repetition / length));
  for (const TerminalUse& use : uses) {
    const Ns last = use.next - period, age = last - use.source;
    for (Ns t = last; add(age, most) > worst && t < last + repetition; t += length) {
      const std::size_t row = table.row(to, t);
      const Ns response = table.r_minus_in_row(to, row);
      if (age > 0 || !one_bucket) {
        worst = std::max(worst, add(age, response));
      } else if (!seen[row] && response > worst) {
        seen[row] = true;
        worst = std::max(worst, pair_window(from, to, t));
      }
    }
  }
  return worst;
}

/// Exact maximum over the root's releases in one repetition of everything on the route.
Ns DecisionAnalysis::walk(const Route& r, Ns entries) const {
  const Ns step = model_.devices[r.down.front()].period_ns;
  const Ns period = model_.devices[r.to].period_ns;
  const bool one_bucket = profile_.set.bucket_of[r.from] == profile_.set.bucket_of[r.to];
  const Ns most = profile_.responses.r_minus[r.to];
  std::vector<Ns> use(r.up.size());
  Ns worst = 0;
  effort_.spend(entries * static_cast<Ns>(r.up.size() + r.down.size()) * 2);
  for (Ns i = 0; i < entries; ++i) {
    const Ns x = i * step;
    Ns later = x + step;
    for (std::size_t k = 1; k < r.down.size(); ++k) later = hand_down(later, r.down[k - 1], r.down[k]);
    const Ns t = later - period;
    use[0] = x;
    for (std::size_t k = 1; k < r.up.size(); ++k) {
      use[k] = kNever;
      for (const std::size_t c : r.consumers[k]) use[k] = std::min(use[k], used(use[c], r.up[k], r.up[c]));
    }
    const Ns age = t - use.back();
    if (add(age, most) <= worst) continue;
    const Ns response = profile_.table.r_minus(r.to, t);
    if (add(age, response) <= worst) continue;
    worst = std::max(worst, age == 0 && one_bucket ? pair_window(r.from, r.to, t) : add(age, response));
  }
  return worst;
}

/// Per edge the largest age data can have, T_producer - g + g ceil(r/g); over several routes the largest sum.
Ns DecisionAnalysis::closed_form(const Route& r) const {
  const auto hop = [&](Rank producer, Rank consumer, Ns response) {
    const Ns from = model_.devices[producer].period_ns, to = model_.devices[consumer].period_ns;
    if (from == to) return producer < consumer || response == kNone ? Ns{0} : from;
    const Ns common = std::gcd(from, to);
    const Ns lag = from > to ? round_up(std::max(response, profile_.set.least_lag), common) : 0;
    return add(from - common, lag);
  };
  Ns age = 0;
  for (std::size_t k = 1; k < r.down.size(); ++k) {
    const Rank producer = r.down[k - 1];
    const bool same = model_.devices[producer].period_ns == model_.devices[r.down[k]].period_ns;
    if (!same) age = add(age, hop(producer, r.down[k], profile_.responses.r_minus[producer]));
  }
  std::vector<Ns> oldest(r.up.size(), 0);
  for (std::size_t k = 1; k < r.up.size(); ++k) {
    for (const std::size_t c : r.consumers[k]) {
      oldest[k] = std::max(oldest[k], add(oldest[c], hop(r.up[k], r.up[c], profile_.responses.r_plus[r.up[k]])));
    }
  }
  return add(add(age, oldest.back()), profile_.responses.r_minus[r.to]);
}

Decision DecisionAnalysis::decide(Rank from, Rank to) const {
  Decision result;
  if (hand_over_[from] && hand_over_[to] && topology_.root_of[from] == topology_.root_of[to]) {
    const Ns age = join_hand_overs(from, to);
    if (age != kNone) return {age, false, false};
  }
  const Route r = route(from, to);
  result.through_reads = r.through_reads;
  Ns common = 1;
  for (const auto* devices : {&r.down, &r.up}) {
    for (const Rank d : *devices) {
      if (!profile_.responses.ok(profile_.set.bucket_of[d])) return result;
      common = lcm(common, profile_.table.repeat(d));
    }
  }
  const Ns entries = common / model_.devices[r.down.front()].period_ns;
  result.closed_form = entries > kMostEntries;
  result.ns = result.closed_form ? closed_form(r) : walk(r, entries);
  return result;
}

}  // namespace finemote::gen::timing
