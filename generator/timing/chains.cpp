#include "generator/timing/chains.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "generator/timing/oldest.hpp"

namespace finemote::gen::timing {
namespace {

constexpr Ns kMostEntries = 1'000'000;
constexpr Ns kMostPairEntries = Ns{1} << 18;  ///< pairs of leaves times root releases looked at for each

std::optional<Ns> sum(std::optional<Ns> a, std::optional<Ns> b) {
  return a && b ? std::optional<Ns>(add(*a, *b)) : std::nullopt;
}

/// Orders bounds, unbounded last.
bool less(std::optional<Ns> a, std::optional<Ns> b) { return a && (!b || *a < *b); }

/// Whether the data of `a` are older when the command is made.
bool is_older(const ChainResult& a, const ChainResult& b) {
  return less(sum(b.acquire_ns, b.decide_ns), sum(a.acquire_ns, a.decide_ns));
}

}  // namespace

/// The devices of a chain: down from the root to the terminal, and everything between the source and the root.
struct ChainAnalysis::Route {
  std::size_t from = 0, to = 0;
  std::vector<std::size_t> down;                    ///< root first, terminal last
  std::vector<std::size_t> up;                      ///< root first, source last; every producer after its consumers
  std::vector<std::vector<std::size_t>> consumers;  ///< per entry of `up`: places in `up`
  bool through_reads = false;
};

ChainAnalysis::ChainAnalysis(const Model& model, const Topology& topology, const ProfileAnalysis& profile,
                             const WireAnalysis& wire, Effort& effort, std::size_t most_pairs)
    : model_(model),
      topology_(topology),
      profile_(profile),
      wire_(wire),
      effort_(effort),
      most_pairs_(most_pairs),
      consumers_(model.devices.size()) {
  for (std::size_t d = 0; d < model.devices.size(); ++d) {
    const Device& device = model.devices[d];
    if (device.parent) consumers_[d].push_back(*device.parent);
    for (const std::size_t observed : device.reads) consumers_[observed].push_back(d);
    if (device.source == WcetSource::assumed) assumed_from_ = std::min(assumed_from_, device.period_ns);
    acquire_.push_back(wire.acquisition(d));
  }
  find_hand_overs();
  updates_from_.resize(model.devices.size());
  handles_from_.resize(model.devices.size());
  for (const TaskBucket& bucket : profile.set.buckets) {
    Ns updates = 0, handles = 0;
    for (auto d = bucket.devices.rbegin(); d != bucket.devices.rend(); ++d) {
      updates_from_[*d] = updates = add(updates, profile.set.update[*d]);
      handles_from_[*d] = handles = add(handles, profile.set.handle[*d]);
    }
  }
}

/// Of every device of a tree that was walked, unless closed forms stand in, and unless other ways lead through reads.
void ChainAnalysis::find_hand_overs() {
  reads_in_tree_of_.resize(model_.devices.size());
  for (std::size_t d = 0; d < model_.devices.size(); ++d) {
    if (!model_.devices[d].reads.empty()) reads_in_tree_of_[topology_.root_of[d]] = true;
  }
  hand_over_.resize(model_.devices.size());
  for (const std::size_t root : topology_.roots) {
    const auto* groups = reads_in_tree_of_[root] ? nullptr : profile_.hand_overs->walked(root);
    if (groups == nullptr) continue;
    for (const HandOverGroup& group : *groups) {
      for (const std::size_t d : group.devices) hand_over_[d] = group.exact;
    }
  }
}

bool ChainAnalysis::ends_at(std::size_t producer, std::size_t consumer) const {
  const auto& ends = model_.devices[consumer].ends_here;
  return std::find(ends.begin(), ends.end(), producer) != ends.end();
}

bool ChainAnalysis::connected(std::size_t from, std::size_t to) const {
  std::set<std::size_t> goals{to};  // every device whose handle() has a part in the command of `to`
  for (std::size_t d = to; model_.devices[d].parent; d = *model_.devices[d].parent)
    goals.insert(*model_.devices[d].parent);
  std::vector<std::size_t> stack{from};
  std::set<std::size_t> seen{from};
  while (!stack.empty()) {
    const std::size_t device = stack.back();
    stack.pop_back();
    if (goals.contains(device)) return true;
    for (const std::size_t consumer : consumers_[device]) {
      if (consumer != to && ends_at(device, consumer)) continue;
      if (seen.insert(consumer).second) stack.push_back(consumer);
    }
  }
  return false;
}

ChainAnalysis::Route ChainAnalysis::route(std::size_t from, std::size_t to) const {
  Route r{from, to, {to}, {}, {}, false};
  while (model_.devices[r.down.back()].parent) r.down.push_back(*model_.devices[r.down.back()].parent);
  std::reverse(r.down.begin(), r.down.end());
  const std::size_t root = r.down.front();
  // Depth first from the source; a device is finished after all its consumers, and kept when the root is above it.
  std::map<std::size_t, bool> reaches;
  std::vector<std::pair<std::size_t, std::size_t>> stack{{from, 0}};
  while (!stack.empty()) {
    auto& [device, next] = stack.back();
    if (device == root || next == consumers_[device].size()) {
      bool good = device == root;
      for (const std::size_t c : consumers_[device]) good |= device != root && reaches[c];
      reaches[device] = good;
      if (good) r.up.push_back(device);
      stack.pop_back();
      continue;
    }
    const std::size_t consumer = consumers_[device][next++];
    if (!reaches.contains(consumer)) stack.emplace_back(consumer, 0);
  }
  std::map<std::size_t, std::size_t> place;
  for (const std::size_t device : r.up) {
    auto& list = r.consumers.emplace_back();
    for (const std::size_t c : consumers_[device]) {
      if (device == root || !place.contains(c)) continue;
      list.push_back(place[c]);
      r.through_reads |= model_.devices[device].parent != c;
    }
    place[device] = r.consumers.size() - 1;
  }
  return r;
}

/// First release of `consumer` whose handle() sees what the release of `producer` decided.
Ns ChainAnalysis::hand_down(Ns release, std::size_t producer, std::size_t consumer) const {
  const Ns period = model_.devices[consumer].period_ns;
  Ns ready = release;
  if (model_.devices[producer].period_ns > period) {
    ready = add(ready, std::max(profile_.table.r_minus(producer, release), profile_.set.least_lag));
  }
  return round_up(ready, period);
}

/// Release of `producer` whose state the release of `consumer` uses at `use`, or an older one.
Ns ChainAnalysis::used(Ns use, std::size_t producer, std::size_t consumer) const {
  const Ns period = model_.devices[producer].period_ns;
  const Ns release = round_down(use, period);
  if (period == model_.devices[consumer].period_ns) return producer < consumer ? release : release - period;
  if (period < model_.devices[consumer].period_ns) return release;
  const Ns ready = add(release, std::max(profile_.table.r_plus(producer, release), profile_.set.least_lag));
  return ready > use ? release - period : release;
}

/// Begin of update(from) to end of handle(to) in one job: W of analysis-cases/README.md for two devices of a bucket.
Ns ChainAnalysis::pair_window(std::size_t from, std::size_t to, Ns release) const {
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
Ns ChainAnalysis::join_hand_overs(std::size_t from, std::size_t to) const {
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
Ns ChainAnalysis::walk(const Route& r, Ns entries) const {
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
Ns ChainAnalysis::closed_form(const Route& r) const {
  const auto hop = [&](std::size_t producer, std::size_t consumer, Ns response) {
    const Ns from = model_.devices[producer].period_ns, to = model_.devices[consumer].period_ns;
    if (from == to) return producer < consumer || response == kNone ? Ns{0} : from;
    const Ns common = std::gcd(from, to);
    const Ns lag = from > to ? round_up(std::max(response, profile_.set.least_lag), common) : 0;
    return add(from - common, lag);
  };
  Ns age = 0;
  for (std::size_t k = 1; k < r.down.size(); ++k) {
    const std::size_t producer = r.down[k - 1];
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

ChainAnalysis::Decision ChainAnalysis::decide(std::size_t from, std::size_t to) const {
  Decision result;
  if (hand_over_[from] && hand_over_[to] && topology_.root_of[from] == topology_.root_of[to]) {
    const Ns age = join_hand_overs(from, to);
    if (age != kNone) return {age, false, false};
  }
  const Route r = route(from, to);
  result.through_reads = r.through_reads;
  Ns common = 1;
  for (const auto* devices : {&r.down, &r.up}) {
    for (const std::size_t d : *devices) {
      if (!profile_.responses.ok(profile_.set.bucket_of[d])) return result;
      common = lcm(common, profile_.table.repeat(d));
    }
  }
  const Ns entries = common / model_.devices[r.down.front()].period_ns;
  result.closed_form = entries > kMostEntries;
  result.ns = result.closed_form ? closed_form(r) : walk(r, entries);
  return result;
}

bool ChainAnalysis::is_assumed(std::size_t from, std::size_t to) const {
  const auto& acquisition = model_.devices[from].acquisition;
  if (acquisition && acquisition->assumed) return true;
  Ns slowest = model_.devices[from].period_ns;
  for (std::size_t d : {from, to}) {
    for (; model_.devices[d].parent; d = *model_.devices[d].parent)
      slowest = std::max(slowest, model_.devices[d].period_ns);
    slowest = std::max(slowest, model_.devices[d].period_ns);
  }
  return assumed_from_ <= slowest;
}

ChainResult ChainAnalysis::complete(std::size_t from, std::size_t to, const Decision& decision) const {
  ChainResult result{from,
                     to,
                     acquire_[from],
                     decision.ns,
                     wire_.command(to),
                     {},
                     is_assumed(from, to),
                     decision.through_reads,
                     decision.closed_form};
  result.end_to_end_ns = sum(sum(result.acquire_ns, result.decide_ns), result.wire_ns);
  return result;
}

ChainResult ChainAnalysis::bound(std::size_t from, std::size_t to) const {
  return complete(from, to, decide(from, to));
}

std::vector<ChainResult> ChainAnalysis::worst_of_pairs(const std::vector<std::size_t>& sources,
                                                       const std::vector<std::size_t>& terminals) const {
  std::vector<ChainResult> results;
  for (const std::size_t to : terminals) {
    ChainResult worst = bound(sources.front(), to);
    for (std::size_t s = 1; s < sources.size(); ++s) {
      ChainResult other = bound(sources[s], to);
      if (is_older(other, worst)) worst = other;
    }
    results.push_back(worst);
  }
  return results;
}

/// The same for large trees: per root release the oldest sample of any source, then per terminal its latest use.
/// Windows within one job are not used.
std::vector<ChainResult> ChainAnalysis::worst_of_groups(std::size_t root, const std::vector<std::size_t>& leaves,
                                                        const std::vector<std::size_t>& terminals) const {
  const auto walk_groups = [&](const std::function<void(const HandOverGroup&)>& visit) {
    walk_tree(model_, topology_, profile_.responses, profile_.set, profile_.table, root, *profile_.hand_overs, effort_,
              visit);
  };
  bool complete_tree = true;
  for (const std::size_t leaf : leaves) {
    complete_tree &= profile_.responses.ok(profile_.set.bucket_of[leaf]) && acquire_[leaf].has_value();
  }
  OldestSources sources(model_.devices[root].period_ns);
  walk_groups([&](const HandOverGroup& group) {
    OldestSources::Oldest best;
    for (const std::size_t d : group.devices) {
      const bool is_source = std::binary_search(leaves.begin(), leaves.end(), d);
      if (is_source && acquire_[d]) best.offer({*acquire_[d], d});
    }
    if (best.age >= 0) sources.add_group(group, best);
  });
  const std::set<std::size_t> wanted(terminals.begin(), terminals.end());
  std::map<std::size_t, ChainResult> found;
  walk_groups([&](const HandOverGroup& group) {
    const auto is_wanted = [&](std::size_t d) { return wanted.contains(d); };
    if (std::none_of(group.devices.begin(), group.devices.end(), is_wanted)) return;
    const OldestSources::Oldest worst = sources.worst(group);
    effort_.spend(group.exact ? static_cast<Ns>(group.exact->down->steps.size()) : 1);
    if (worst.age < 0) return;
    for (const std::size_t d : group.devices) {
      if (!is_wanted(d)) continue;
      const Ns decide = worst.age - *acquire_[worst.source] + profile_.responses.r_minus[d];
      const bool is_closed = group.exact == nullptr || sources.has_closed_form();
      found.emplace(d, complete(worst.source, d, {decide, is_closed, false}));
    }
  });
  std::vector<ChainResult> results;
  for (const std::size_t to : terminals) {
    const auto entry = found.find(to);
    results.push_back(entry != found.end() && complete_tree ? entry->second : complete(leaves.front(), to, {}));
  }
  return results;
}

/// Nanoseconds until everything about these devices repeats; kNever when that leaves the range of numbers.
Ns ChainAnalysis::repetition(const std::vector<std::size_t>& devices) const {
  Ns length = 1;
  try {
    for (const std::size_t d : devices) length = lcm(length, profile_.table.repeat(d));
  } catch (const Overflow&) {
    return kNever;
  }
  return length;
}

/// The root, everything below an edge that data end at, and the terminal where data end at itself: whatever is between
/// two of them is reached from the upper one.
ChainAnalysis::Turns ChainAnalysis::turns_above(std::size_t to) const {
  Turns turns;
  if (!model_.devices[to].ends_here.empty()) turns.end = to;
  std::size_t d = to;
  for (; model_.devices[d].parent; d = *model_.devices[d].parent) {
    if (ends_at(d, *model_.devices[d].parent) || turns.end == d) turns.devices.push_back(d);
  }
  turns.devices.push_back(d);
  return turns;
}

/// Devices with a sample of their own whose data reach one of the turns: those without children, and those that
/// measure. Data of any other device are as old as what it was made from.
std::vector<std::size_t> ChainAnalysis::sources_of(const Turns& turns) const {
  std::vector<std::size_t> stack = turns.devices, sources;
  std::set<std::size_t> seen(stack.begin(), stack.end());
  while (!stack.empty()) {
    const std::size_t device = stack.back();
    stack.pop_back();
    if (topology_.children[device].empty() || model_.devices[device].acquisition) sources.push_back(device);
    std::vector<std::size_t> producers = topology_.children[device];
    producers.insert(producers.end(), model_.devices[device].reads.begin(), model_.devices[device].reads.end());
    for (const std::size_t producer : producers) {
      if (device != turns.end && ends_at(producer, device)) continue;
      if (seen.insert(producer).second) stack.push_back(producer);
    }
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

/// The source with the largest bound, per terminal; all terminals are of one tree. There is a source.
std::vector<ChainResult> ChainAnalysis::worst_of(const std::vector<std::size_t>& sources,
                                                 const std::vector<std::size_t>& terminals) const {
  const std::size_t root = topology_.root_of[terminals.front()];
  std::vector<std::size_t> concerned = sources;
  for (const std::size_t source : sources) {
    for (std::size_t d = source; model_.devices[d].parent; d = *model_.devices[d].parent)
      concerned.push_back(*model_.devices[d].parent);
  }
  concerned.insert(concerned.end(), terminals.begin(), terminals.end());
  const std::size_t pairs = sources.size() * terminals.size();
  const Ns entries = repetition(concerned) / model_.devices[root].period_ns;
  if (pairs <= most_pairs_ && entries <= kMostPairEntries / static_cast<Ns>(pairs))
    return worst_of_pairs(sources, terminals);

  std::vector<std::size_t> leaves, others;
  for (const std::size_t s : sources) (topology_.children[s].empty() ? leaves : others).push_back(s);
  // Groups know tree edges only, and another way may be older.
  const bool is_known = !reads_in_tree_of_[root] && !leaves.empty() && others.size() * terminals.size() <= most_pairs_;
  std::vector<ChainResult> results;
  if (!is_known) {
    for (const std::size_t to : terminals) results.push_back(complete(sources.front(), to, {}));
    return results;
  }
  results = worst_of_groups(root, leaves, terminals);
  if (others.empty()) return results;
  const std::vector<ChainResult> measured = worst_of_pairs(others, terminals);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (is_older(measured[i], results[i])) results[i] = measured[i];
  }
  return results;
}

/// In the order of `terminals`, which are of one tree, without those that no data reach; those that the same data reach
/// are looked at together.
std::vector<ChainResult> ChainAnalysis::worst_of_all(const std::vector<std::size_t>& terminals) const {
  std::map<Turns, std::vector<std::size_t>> places;  // of terminals
  for (std::size_t i = 0; i < terminals.size(); ++i) places[turns_above(terminals[i])].push_back(i);
  std::vector<std::optional<ChainResult>> found(terminals.size());
  for (const auto& [turns, members] : places) {
    const std::vector<std::size_t> sources = sources_of(turns);
    if (sources.empty()) continue;
    std::vector<std::size_t> of_group;
    for (const std::size_t i : members) of_group.push_back(terminals[i]);
    const std::vector<ChainResult> worst = worst_of(sources, of_group);
    for (std::size_t k = 0; k < members.size(); ++k) found[members[k]] = worst[k];
  }
  std::vector<ChainResult> results;
  for (std::optional<ChainResult>& result : found) {
    if (result) results.push_back(std::move(*result));
  }
  return results;
}

std::vector<ChainResult> ChainAnalysis::defaults() const {
  std::vector<ChainResult> results;
  for (std::size_t tree = 0; tree < topology_.roots.size(); ++tree) {
    std::vector<std::size_t> terminals;
    for (const std::size_t leaf : topology_.leaves[tree]) {
      if (model_.devices[leaf].takes_command) terminals.push_back(leaf);
    }
    if (terminals.empty()) terminals.push_back(topology_.roots[tree]);
    for (ChainResult& r : worst_of_all(terminals)) results.push_back(r);
  }
  return results;
}

std::vector<ChainResult> ChainAnalysis::oldest_inputs() const {
  std::vector<std::vector<std::size_t>> terminals(model_.devices.size());  // per root
  for (std::size_t d = 0; d < model_.devices.size(); ++d) {
    if (model_.devices[d].takes_command && model_.devices[d].parent) terminals[topology_.root_of[d]].push_back(d);
  }
  std::vector<ChainResult> results;
  for (const std::size_t root : topology_.roots) {
    for (ChainResult& r : worst_of_all(terminals[root])) results.push_back(r);
  }
  return results;
}

}  // namespace finemote::gen::timing
