#include "generator/timing/decision.hpp"

#include <algorithm>
#include <map>

#include "generator/units/hyperperiod.hpp"

namespace finemote::gen::timing {
namespace {

/// Depth first up to the root: what `finish` makes of each device goes into `found`, after that of all its consumers.
template <class Of, class Finish>
void consumers_first(const Reach& reach, Rank from, Rank root, std::map<Rank, Of>& found, const Finish& finish) {
  std::vector<std::pair<Rank, std::size_t>> stack{{from, 0}};
  while (!stack.empty()) {
    auto& [device, next] = stack.back();
    if (found.contains(device)) {
      stack.pop_back();
    } else if (device == root || next == reach.consumers(device).size()) {
      found.emplace(device, finish(device));
      stack.pop_back();
    } else {
      const Rank consumer = reach.consumers(device)[next++];
      stack.emplace_back(consumer, 0);
    }
  }
}

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
      windows_(profile, effort),
      is_general_(general_up_to_root(model, profile.set, profile.table)) {
  find_hand_overs();
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
  std::map<Rank, bool> reaches;
  consumers_first(reach_, from, root, reaches, [&](Rank device) {  // kept when the root is above it
    bool good = device == root;
    for (const Rank c : reach_.consumers(device)) good |= device != root && reaches[c];
    if (good) r.up.push_back(device);
    return good;
  });
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
Duration DecisionAnalysis::hand_down(Duration release, Rank producer, Rank consumer) const {
  const Duration period = model_.devices[consumer].period;
  Duration ready = release;
  if (model_.devices[producer].period > period) {
    ready += profile_.table.r_minus(producer, release) + profile_.set.lag_of_handle(producer, period);
  }
  return round_up(ready, period);
}

/// Release of `producer` whose state the release of `consumer` uses at `use`, or an older one.
Duration DecisionAnalysis::used(Duration use, Rank producer, Rank consumer) const {
  const Duration period = model_.devices[producer].period;
  const Duration release = round_down(use, period);
  if (period == model_.devices[consumer].period) return producer < consumer ? release : release - period;
  if (period < model_.devices[consumer].period) return release;
  const Duration ready = release + profile_.table.r_plus(producer, release) +
                         profile_.set.lag_of_update(producer, model_.devices[consumer].period);
  return ready > use ? release - period : release;
}

/// Start of update(from) to end of handle(to), both in jobs released at `release`.
Duration DecisionAnalysis::released_together(Rank from, Rank to, Duration release, Duration response) const {
  const std::size_t first = profile_.set.bucket_of[from], last = profile_.set.bucket_of[to];
  if (first == last) return windows_.in_one_job(from, to, release);
  return windows_.spans(first, last) ? windows_.in_two_jobs(from, to, release) : response;
}

/// The same maximum from what the latency analysis walked; kNone where it is beyond the limits.
Duration DecisionAnalysis::join_hand_overs(Rank from, Rank to) const {
  const Staircase &down = *hand_over_[to]->down, &up = *hand_over_[from]->up;
  const ReleaseTable& table = profile_.table;
  const auto joined = common_multiple(down.length, up.length);
  const auto whole = table.rows(to) > 1 ? common_multiple(joined, table.repeat(to)) : joined;
  if (!whole || floor_div(*whole, model_.devices[topology_.root_of[to]].period) > effort_.most_releases()) return kNone;
  const Duration length = *joined, repetition = *whole;
  if (!effort_.spend(steps_in(down, length) + steps_in(up, length) + static_cast<std::int64_t>(table.rows(to))))
    return kNone;
  const Duration period = model_.devices[to].period;
  const bool one_bucket = profile_.set.bucket_of[from] == profile_.set.bucket_of[to];
  const Duration most = table.r_minus_range(to).most;
  std::vector<bool> seen(table.rows(to));  // releases in one row have one window
  Duration worst;
  const auto look_at = [&](Duration release, std::size_t row, Duration age) {
    const Duration response = table.r_minus_in_row(to, row);
    if (age + response <= worst) return;
    if (age > Duration::zero()) {
      worst = std::max(worst, age + response);
    } else if (!one_bucket || !seen[row]) {
      seen[row] = true;
      worst = std::max(worst, released_together(from, to, release, response));
    }
  };
  const std::vector<TerminalUse> uses = join(down, up, length);
  for (const TerminalUse& use : uses) {
    const Duration last = use.next - period, age = last - use.source;
    if (age + most <= worst) continue;
    if (length == period) {  // every release has this age
      for (std::size_t row = 0; row < table.rows(to); ++row) look_at(table.release_of_row(to, row), row, age);
      continue;
    }
    if (!effort_.spend(floor_div(repetition, length))) return kNone;
    for (Duration t = last; age + most > worst && t < last + repetition; t += length) look_at(t, table.row(to, t), age);
  }
  return worst;
}

/// Exact maximum over the root's releases in one repetition of everything on the route.
Duration DecisionAnalysis::walk(const Route& r, std::int64_t entries) const {
  const Duration step = model_.devices[r.down.front()].period;
  const Duration period = model_.devices[r.to].period;
  const Duration most = profile_.responses.r_minus[r.to];
  std::vector<Duration> use(r.up.size());
  Duration worst;
  for (std::int64_t i = 0; i < entries; ++i) {
    const Duration x = i * step;
    Duration later = x + step;
    for (std::size_t k = 1; k < r.down.size(); ++k) later = hand_down(later, r.down[k - 1], r.down[k]);
    const Duration t = later - period;
    use[0] = x;
    for (std::size_t k = 1; k < r.up.size(); ++k) {
      use[k] = kNever;
      for (const std::size_t c : r.consumers[k]) use[k] = std::min(use[k], used(use[c], r.up[k], r.up[c]));
    }
    const Duration age = t - use.back();
    if (age + most <= worst) continue;
    const Duration response = profile_.table.r_minus(r.to, t);
    if (age + response <= worst) continue;
    worst = std::max(worst, age == Duration::zero() ? released_together(r.from, r.to, t, response) : age + response);
  }
  return worst;
}

/// The largest age that data can have where they are handed over: T_producer - g + g ceil(r/g).
/// @param there  when they are there, from the producer's release on
Duration DecisionAnalysis::hop(Rank producer, Rank consumer, Duration there) const {
  const Duration from = model_.devices[producer].period, to = model_.devices[consumer].period;
  if (from == to) return producer < consumer ? Duration::zero() : from;
  const Duration common = gcd(from, to);
  return from - common + (from > to ? round_up(there, common) : Duration::zero());
}

Duration DecisionAnalysis::hop_up(Rank producer, Rank consumer) const {
  const Duration lag = profile_.set.lag_of_update(producer, model_.devices[consumer].period);
  return hop(producer, consumer, profile_.responses.r_plus[producer] + lag);
}

Duration DecisionAnalysis::hop_down(Rank producer, Rank consumer) const {
  const Duration period = model_.devices[consumer].period;
  if (model_.devices[producer].period == period) return Duration::zero();
  return hop(producer, consumer, profile_.responses.r_minus[producer] + profile_.set.lag_of_handle(producer, period));
}

/// Of each edge the largest; over several routes the largest sum.
Duration DecisionAnalysis::closed_form(const Route& r) const {
  Duration age;
  for (std::size_t k = 1; k < r.down.size(); ++k) age += hop_down(r.down[k - 1], r.down[k]);
  std::vector<Duration> oldest(r.up.size());
  for (std::size_t k = 1; k < r.up.size(); ++k) {
    for (const std::size_t c : r.consumers[k]) oldest[k] = std::max(oldest[k], oldest[c] + hop_up(r.up[k], r.up[c]));
  }
  return age + oldest.back() + profile_.responses.r_minus[r.to];
}

std::map<Rank, DecisionAnalysis::WayUp> DecisionAnalysis::ways_up(Rank root, const std::vector<Rank>& sources) const {
  std::map<Rank, WayUp> ways;
  const auto finished = [&](Rank device) {
    WayUp way;
    way.reaches = device == root;
    if (profile_.responses.ok(profile_.set.bucket_of[device])) way.age = Duration::zero();
    for (const Rank c : reach_.consumers(device)) {
      if (device == root) break;
      const WayUp& further = ways.at(c);
      if (!further.reaches) continue;
      way.reaches = true;
      way.through_reads |= further.through_reads || model_.devices[device].parent != c;
      if (!further.age) way.age = std::nullopt;
      if (way.age) way.age = std::max(*way.age, *further.age + hop_up(device, c));
    }
    if (!way.reaches) way.age = std::nullopt;
    return way;
  };
  for (const Rank source : sources) consumers_first(reach_, source, root, ways, finished);
  return ways;
}

Decision DecisionAnalysis::decide(const WayUp& way, Rank to) const {
  Decision result{std::nullopt, false, way.through_reads};
  if (!way.age) return result;
  Duration latency = *way.age + profile_.responses.r_minus[to];
  for (Rank d = to;; d = *model_.devices[d].parent) {
    if (!profile_.responses.ok(profile_.set.bucket_of[d])) return result;
    if (!model_.devices[d].parent) break;
    latency += hop_down(*model_.devices[d].parent, d);
  }
  result.latency = latency;
  result.closed_form = true;
  return result;
}

Decision DecisionAnalysis::decide(Rank from, Rank to) const {
  Decision result;
  if (hand_over_[from] && hand_over_[to] && topology_.root_of[from] == topology_.root_of[to]) {
    const Duration age = join_hand_overs(from, to);
    if (age != kNone) return {age, is_general(from) || is_general(to) || effort_.is_spent(), false};
  }
  const Route r = route(from, to);
  result.through_reads = r.through_reads;
  std::optional<Duration> common = nanoseconds(1);
  for (const auto* devices : {&r.down, &r.up}) {
    for (const Rank d : *devices) {
      if (!profile_.responses.ok(profile_.set.bucket_of[d])) return result;
      common = common_multiple(common, profile_.table.repeat(d));
      result.closed_form |= is_general(d);
    }
  }
  constexpr std::int64_t kStepsPerDevice = 8;  // for one release of the root
  const auto steps = kStepsPerDevice * static_cast<std::int64_t>(r.up.size() + r.down.size());
  const std::int64_t entries = common ? floor_div(*common, model_.devices[r.down.front()].period) : kUnlimited;
  if (entries <= effort_.most_releases() && effort_.spend(entries * steps)) {
    result.latency = walk(r, entries);
    result.closed_form |= effort_.is_spent();  // on a window within one job
  } else {
    result.closed_form = true;
    result.latency = closed_form(r);
  }
  return result;
}

}  // namespace finemote::gen::timing
