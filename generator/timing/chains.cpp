#include "generator/timing/chains.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "generator/timing/oldest.hpp"
#include "generator/timing/true_time.hpp"
#include "generator/units/hyperperiod.hpp"

namespace finemote::gen::timing {
namespace {

constexpr std::int64_t kMostPairEntries = std::int64_t{1}
                                          << 18;  ///< pairs of leaves times root releases looked at for each

/// So many times as many pairs are looked at one by one where groups cannot stand in.
constexpr std::size_t kMoreWithReads = 8;
constexpr std::size_t kMostOnWays = 1U << 16;

std::optional<Duration> sum(std::optional<Duration> a, std::optional<Duration> b) {
  return a && b ? std::optional<Duration>(*a + *b) : std::nullopt;
}

/// Orders bounds, unbounded last.
bool less(std::optional<Duration> a, std::optional<Duration> b) { return a && (!b || *a < *b); }

/// Whether the data of `a` are older when the command is made.
bool is_older(const ChainResult& a, const ChainResult& b) { return less(b.age, a.age); }

}  // namespace

ChainAnalysis::ChainAnalysis(const Model& model, const Topology& topology, const ProfileAnalysis& profile,
                             const WireAnalysis& wire, Table<Rank, std::optional<Duration>> ages, Effort& effort,
                             std::size_t most_pairs)
    : model_(model),
      topology_(topology),
      profile_(profile),
      wire_(wire),
      effort_(effort),
      most_pairs_(most_pairs),
      reach_(model, topology),
      decisions_(model, topology, reach_, profile, effort),
      acquire_(std::move(ages)) {
  for (const Rank d : model.devices.ids()) {
    const Device& device = model.devices[d];
    if (device.source == WcetSource::assumed) assumed_from_ = std::min(assumed_from_, device.period);
  }
}

bool ChainAnalysis::is_assumed(Rank from, Rank to) const {
  const auto& acquisition = model_.devices[from].acquisition;
  if (acquisition && acquisition->assumed) return true;
  Duration slowest = model_.devices[from].period;
  for (Rank d : {from, to}) {
    for (; model_.devices[d].parent; d = *model_.devices[d].parent)
      slowest = std::max(slowest, model_.devices[d].period);
    slowest = std::max(slowest, model_.devices[d].period);
  }
  return assumed_from_ <= slowest;
}

ChainResult ChainAnalysis::complete(Rank from, Rank to, const Decision& decision) const {
  ChainResult result;
  result.from = from;
  result.to = to;
  result.acquire = true_bound(model_, acquire_[from]);
  result.decide = true_bound(model_, decision.latency);
  result.wire = true_bound(model_, wire_.command(to));
  result.assumed = is_assumed(from, to);
  result.through_reads = decision.through_reads;
  result.closed_form = decision.closed_form;
  result.age = sum(result.acquire, result.decide);
  result.end_to_end = sum(result.age, result.wire);
  return result;
}

ChainResult ChainAnalysis::bound(Rank from, Rank to) const { return complete(from, to, decisions_.decide(from, to)); }

std::vector<ChainResult> ChainAnalysis::worst_of_pairs(const std::vector<Rank>& sources,
                                                       const std::vector<Rank>& terminals) const {
  std::vector<ChainResult> results;
  for (const Rank to : terminals) {
    ChainResult worst = bound(sources.front(), to);
    for (std::size_t s = 1; s < sources.size(); ++s) {
      ChainResult other = bound(sources[s], to);
      if (is_older(other, worst)) worst = other;
    }
    results.push_back(worst);
  }
  return results;
}

/// The same for large trees with ways through reads: in closed form, which is never smaller.
std::vector<ChainResult> ChainAnalysis::worst_in_closed_form(Rank root, const std::vector<Rank>& sources,
                                                             const std::vector<Rank>& terminals) const {
  const std::map<Rank, DecisionAnalysis::WayUp> ways = decisions_.ways_up(root, sources);
  const auto age_of = [&](Rank source) { return sum(acquire_[source], ways.at(source).age); };
  const Rank oldest =
      *std::max_element(sources.begin(), sources.end(), [&](Rank a, Rank b) { return less(age_of(a), age_of(b)); });
  std::vector<ChainResult> results;
  for (const Rank to : terminals) results.push_back(complete(oldest, to, decisions_.decide(ways.at(oldest), to)));
  return results;
}

/// The first whose data have no bound, or a job on their way to the root.
std::optional<Rank> ChainAnalysis::first_unbounded(const std::vector<Rank>& sources) const {
  Table<Rank, bool> is_seen(model_.devices.size());
  for (const Rank source : sources) {
    if (!acquire_[source]) return source;
    for (std::optional<Rank> d = source; d && !is_seen[*d]; d = model_.devices[*d].parent) {
      if (!profile_.responses.ok(profile_.set.bucket_of[*d])) return source;
      is_seen[*d] = true;
    }
  }
  return std::nullopt;
}

/// The same for large trees: per root release the oldest sample of any source, then per terminal its latest use.
/// Windows within one job are not used.
std::vector<ChainResult> ChainAnalysis::worst_of_groups(Rank root, const std::vector<Rank>& leaves,
                                                        const std::vector<Rank>& terminals) const {
  const auto walk_groups = [&](const std::function<void(const HandOverGroup&)>& visit) {
    walk_tree(model_, topology_, profile_.responses, profile_.set, profile_.table, root, *profile_.hand_overs, effort_,
              visit);
  };
  std::vector<ChainResult> results;
  if (const std::optional<Rank> unbounded = first_unbounded(leaves)) {
    for (const Rank to : terminals) results.push_back(bound(*unbounded, to));
    return results;
  }
  OldestSources sources(model_.devices[root].period, effort_);
  walk_groups([&](const HandOverGroup& group) {
    OldestSources::Oldest best;
    for (const Rank d : group.devices) {
      const bool is_source = std::binary_search(leaves.begin(), leaves.end(), d);
      if (is_source && acquire_[d]) best.offer({*acquire_[d], d});
    }
    if (best.age >= Duration::zero()) sources.add_group(group, best);
  });
  const std::set<Rank> wanted(terminals.begin(), terminals.end());
  std::map<Rank, ChainResult> found;
  walk_groups([&](const HandOverGroup& group) {
    const auto is_wanted = [&](Rank d) { return wanted.contains(d); };
    if (std::none_of(group.devices.begin(), group.devices.end(), is_wanted)) return;
    const OldestSources::Oldest worst = sources.worst(group);
    if (worst.age < Duration::zero()) return;
    for (const Rank d : group.devices) {
      if (!is_wanted(d)) continue;
      const Duration decide = worst.age - *acquire_[worst.source] + profile_.responses.r_minus[d];
      const bool is_closed = group.exact == nullptr || sources.has_closed_form() || decisions_.is_general(d) ||
                             decisions_.is_general(worst.source);
      found.emplace(d, complete(worst.source, d, {decide, is_closed, false}));
    }
  });
  for (const Rank to : terminals) {
    const auto entry = found.find(to);
    results.push_back(entry != found.end() ? entry->second : complete(leaves.front(), to, {}));
  }
  return results;
}

/// Time until everything about these devices repeats; kNever when that leaves the range of numbers.
Duration ChainAnalysis::repetition(const std::vector<Rank>& devices) const {
  std::optional<Duration> length = nanoseconds(1);
  for (const Rank d : devices) length = common_multiple(length, profile_.table.repeat(d));
  return length.value_or(kNever);
}

/// The source with the largest bound, per terminal; all terminals are of one tree. There is a source.
std::vector<ChainResult> ChainAnalysis::worst_of(const std::vector<Rank>& sources,
                                                 const std::vector<Rank>& terminals) const {
  const Rank root = topology_.root_of[terminals.front()];
  std::vector<Rank> concerned = sources;
  for (const Rank source : sources) {
    for (Rank d = source; model_.devices[d].parent; d = *model_.devices[d].parent)
      concerned.push_back(*model_.devices[d].parent);
  }
  concerned.insert(concerned.end(), terminals.begin(), terminals.end());
  const std::size_t pairs = sources.size() * terminals.size();
  const std::int64_t entries = floor_div(repetition(concerned), model_.devices[root].period);
  if (pairs <= most_pairs_ && entries <= kMostPairEntries / static_cast<std::int64_t>(pairs))
    return worst_of_pairs(sources, terminals);

  std::vector<Rank> leaves, others;
  for (const Rank s : sources) (topology_.children[s].empty() ? leaves : others).push_back(s);
  // Groups know tree edges only, and another way may be older.
  const bool is_known =
      !reach_.reads_in_tree_of(root) && !leaves.empty() && others.size() * terminals.size() <= most_pairs_;
  if (!is_known) {
    const std::size_t devices = concerned.size() * terminals.size();  // on the ways of all pairs
    const bool are_few = pairs <= kMoreWithReads * most_pairs_ && devices <= kMostOnWays &&
                         entries <= kMostPairEntries / static_cast<std::int64_t>(pairs);
    return are_few ? worst_of_pairs(sources, terminals) : worst_in_closed_form(root, sources, terminals);
  }
  std::vector<ChainResult> results = worst_of_groups(root, leaves, terminals);
  if (others.empty()) return results;
  const std::vector<ChainResult> measured = worst_of_pairs(others, terminals);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (is_older(measured[i], results[i])) results[i] = measured[i];
  }
  return results;
}

/// In the order of `terminals`, which are of one tree, without those that no data reach; those that the same data reach
/// are looked at together.
std::vector<ChainResult> ChainAnalysis::worst_of_all(const std::vector<Rank>& terminals,
                                                     const std::function<Reach::Turns(Rank)>& turns_of) const {
  std::map<Reach::Turns, std::vector<std::size_t>> places;  // of terminals
  for (std::size_t i = 0; i < terminals.size(); ++i) places[turns_of(terminals[i])].push_back(i);
  std::vector<std::optional<ChainResult>> found(terminals.size());
  for (const auto& [turns, members] : places) {
    const std::vector<Rank> sources = reach_.sources_of(turns);
    if (sources.empty()) continue;
    std::vector<Rank> of_group;
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
    std::vector<Rank> terminals;
    for (const Rank leaf : topology_.leaves[tree]) {
      if (model_.devices[leaf].takes_command) terminals.push_back(leaf);
    }
    if (terminals.empty()) terminals.push_back(topology_.roots[tree]);
    for (ChainResult& r : worst_of_all(terminals, [&](Rank to) { return reach_.turns_above(to); }))
      results.push_back(r);
  }
  return results;
}

std::vector<ChainResult> ChainAnalysis::oldest_inputs() const {
  Table<Rank, std::vector<Rank>> terminals(model_.devices.size());  // of roots
  for (const Rank d : model_.devices.ids()) {
    if (model_.devices[d].takes_command && model_.devices[d].parent) terminals[topology_.root_of[d]].push_back(d);
  }
  std::vector<ChainResult> results;
  for (const Rank root : topology_.roots) {
    const auto turns_of = [&](Rank to) { return reach_.turns_into_command(to); };
    for (ChainResult& r : worst_of_all(terminals[root], turns_of)) results.push_back(r);
  }
  return results;
}

std::vector<ChainResult> ChainAnalysis::every() const {
  std::vector<ChainResult> results;
  for (const Rank to : model_.devices.ids()) {
    if (!model_.devices[to].takes_command) continue;
    for (const Rank from : reach_.sources_of(reach_.turns_above(to))) {
      if (results.size() < kMostPairs) results.push_back(bound(from, to));
    }
  }
  return results;
}

}  // namespace finemote::gen::timing
