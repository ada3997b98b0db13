#include "generator/timing/remedy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "generator/timing/shares.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

constexpr std::array<std::int64_t, 9> kFactors = {2, 3, 4, 5, 6, 8, 10, 16, 20};

/// Robots that are analysed to find hints: fewer where one takes long.
int most_robots(std::size_t devices) {
  constexpr std::size_t kMost = 200, kLeast = 6, kDevices = 60'000;  // devices analysed in all
  return static_cast<int>(std::clamp(kDevices / std::max<std::size_t>(devices, 1), kLeast, kMost));
}

std::size_t unbounded(const Timing& timing) {
  return static_cast<std::size_t>(std::count_if(timing.chains.begin(), timing.chains.end(),
                                                [](const ChainResult& chain) { return !chain.end_to_end; }));
}

Change period_change(const std::vector<Rank>& devices, Duration period) {
  return {Change::Kind::period, devices, {}, period};
}

Family other_rates(const Model& model, BusPlace bus, const std::vector<BusAdvice::Rate>& rates) {
  Family family;
  for (const BusAdvice::Rate& rate : rates)
    family.push_back({{{Change::Kind::rate, {}, bus, {}, rate.bps}},
                      fmt::format("{} at bus '{}'", rate.text, model.buses[bus].name)});
  return family;
}

/// What could make the processor less full without changing any code, one thing at a time.
std::vector<Family> settings(const Timing& timing) {
  std::vector<Family> families;
  for (const BucketResult& bucket : timing.verdict().buckets)
    families.push_back(longer_periods(timing.model, bucket.devices, bucket_text(bucket.period)));
  for (const BusPlace b : timing.model.buses.ids()) families.push_back(slower_rates(timing.model, b));
  return families;
}

/// The work of every bucket.
std::vector<Family> work(const Timing& timing) {
  std::vector<Family> families;
  for (const BucketResult& bucket : timing.verdict().buckets)
    families.push_back(less_work(timing.model, bucket.devices, bucket_text(bucket.period)));
  return families;
}

/// The proposals taken so far: how many of every family.
Proposal joined(const std::vector<Family>& families, const std::vector<std::size_t>& taken) {
  Proposal sum;
  for (std::size_t f = 0; f < families.size(); ++f) {
    if (taken[f] == 0) continue;
    const Proposal& part = families[f][taken[f] - 1];
    sum.changes.insert(sum.changes.end(), part.changes.begin(), part.changes.end());
    sum.text += (sum.text.empty() ? "" : " and ") + part.text;
  }
  return sum;
}

/// Several changes together, each time a step of the one that helps most beside those before. None where that does not
/// reach the goal.
std::optional<Remedy> find_together(Trials& trials, const std::vector<Family>& families, const Goal& goal) {
  constexpr int kMostSteps = 8;
  std::vector<std::size_t> taken(families.size(), 0);
  for (int step = 0; step < kMostSteps; ++step) {
    std::optional<Remedy> best;
    std::size_t chosen = 0;
    for (std::size_t f = 0; f < families.size(); ++f) {
      if (taken[f] == families[f].size()) continue;
      ++taken[f];
      auto found = trials.find({{joined(families, taken)}}, goal, 1);
      --taken[f];
      if (found.empty() || (best && found.front().value >= best->value)) continue;
      best = std::move(found.front());
      chosen = f;
    }
    if (!best || best->enough) return best;
    ++taken[chosen];
  }
  return std::nullopt;
}

}  // namespace

Trials::Trials(const Timing& timing, const AnalysisRequest& request)
    : timing_(timing), remodel_(request.remodel), request_(request), left_(most_robots(timing.model.devices.size())) {
  request_.remodel = nullptr;
  request_.profile = timing.asked;
  request_.inputs = false;
  request_.limits.steps = kTrialLimits.steps;
  request_.chains.clear();
  for (const ChainResult& chain : timing.chains) request_.chains.push_back({chain.from, chain.to});
}

std::optional<Timing> Trials::outcome(const std::vector<Change>& changes, bool verdict_only) {
  if (!remodel_ || left_ <= 0) return std::nullopt;
  --left_;
  try {
    const std::optional<Model> model = remodel_(changes);
    if (!model || !keeps_outputs_together(timing_.model, *model)) return std::nullopt;
    Diagnostics unsaid;
    request_.verdict_only = verdict_only;
    return analyse(*model, request_, unsaid);
  } catch (const Overflow&) {
    return std::nullopt;
  }
}

bool Trials::needs_chains(const Goal& goal) const {
  if (goal.of_chains || timing_.schedulable) return true;
  return std::any_of(timing_.requirements.begin(), timing_.requirements.end(),
                     [](const RequirementResult& r) { return r.requirement.is_latency(); });
}

bool Trials::does_no_harm(const Timing& after) const {
  if (timing_.schedulable && !after.schedulable) return false;
  if (timing_.schedulable && unbounded(after) > unbounded(timing_)) return false;
  for (const BusPlace b : after.bus_loads.ids()) {
    const double now = timing_.bus_loads.contains(b) ? timing_.bus_loads[b].utilization : 0;  // else a new bus
    if (after.bus_loads[b].utilization > std::max(1.0, now)) return false;
  }
  for (std::size_t r = 0; r < after.requirements.size(); ++r) {
    if (timing_.requirements[r].ok && !after.requirements[r].ok) return false;
  }
  return true;
}

std::optional<Remedy> Trials::best_of(const Family& family, const Goal& goal) {
  const double now = goal.value(timing_);
  std::optional<Remedy> best;
  for (const Proposal& proposal : family) {
    const auto after = outcome(proposal.changes, !needs_chains(goal));
    if (!after || !does_no_harm(*after)) continue;
    const double value = goal.value(*after);
    if (value >= now || (best && value >= best->value)) continue;
    best = Remedy{proposal, value, value <= goal.enough, after->processor_load, after->schedulable};
    if (best->enough) return best;
  }
  return best;
}

std::vector<Remedy> Trials::find(const std::vector<Family>& families, const Goal& goal, std::size_t most) {
  std::vector<Remedy> found;
  for (const Family& family : families) {
    if (auto remedy = best_of(family, goal)) found.push_back(std::move(*remedy));
  }
  const bool reached = std::any_of(found.begin(), found.end(), [](const Remedy& r) { return r.enough; });
  if (reached) {
    std::erase_if(found, [](const Remedy& r) { return !r.enough; });
  } else {
    std::stable_sort(found.begin(), found.end(), [](const Remedy& a, const Remedy& b) { return a.value < b.value; });
  }
  if (found.size() > most) found.resize(most);
  return found;
}

Family longer_periods(const Model& model, const std::vector<Rank>& devices, const std::string& who) {
  Family family;
  const auto alike = [&](Rank d) { return model.devices[d].period == model.devices[devices.front()].period; };
  const bool is_one = !devices.empty() && std::all_of(devices.begin(), devices.end(), alike);
  for (const std::int64_t factor : kFactors) {
    Proposal proposal;
    const auto is_long = [&](Rank d) { return model.devices[d].period > floor_div(Duration::max(), factor); };
    if (std::any_of(devices.begin(), devices.end(), is_long)) break;
    for (const Rank d : devices) proposal.changes.push_back(period_change({d}, model.devices[d].period * factor));
    proposal.text =
        is_one ? fmt::format("period=\"{}\" for {}", units::format_duration(proposal.changes.front().period), who)
               : fmt::format("periods {} times as long for {}", factor, who);
    if (!devices.empty()) family.push_back(std::move(proposal));
  }
  return family;
}

Family shorter_periods(const Model& model, const std::vector<Rank>& devices, const std::string& who) {
  Family family;
  if (devices.empty()) return family;
  const Duration period = model.devices[devices.front()].period;
  for (const std::int64_t factor : kFactors) {
    const Duration shorter = floor_div(period, factor);
    if (shorter * factor != period || !is_multiple(shorter, model.tick)) continue;
    family.push_back(
        {{period_change(devices, shorter)}, fmt::format("period=\"{}\" for {}", units::format_duration(shorter), who)});
  }
  return family;
}

Family faster_rates(const Model& model, BusPlace bus) { return other_rates(model, bus, model.buses[bus].advice.rates); }

Family slower_rates(const Model& model, BusPlace bus) {
  return other_rates(model, bus, model.buses[bus].advice.slower);
}

Family other_bus(const Model& model, BusPlace bus) {
  constexpr std::size_t kMostNamed = 8;
  Family family;
  const std::vector<Rank> users = bus_users(model, bus);
  std::size_t last = 0;
  for (const std::size_t parts : {6, 4, 3, 2}) {
    const std::size_t count = users.size() / parts;
    if (count == last || count > kMostNamed || model.buses[bus].advice.other_port.empty()) continue;
    last = count;
    const std::vector<Rank> ones(users.end() - static_cast<std::ptrdiff_t>(count), users.end());
    family.push_back({{{Change::Kind::bus, ones, bus}},
                      model.buses[bus].advice.other_port + " for " + quoted_names(model, ones, kMostNamed)});
  }
  return family;
}

Family less_work(const Model& model, const std::vector<Rank>& devices, const std::string& who) {
  Family family;
  Duration now;
  for (const Rank d : devices) now += model.devices[d].update_wcet + model.devices[d].handle_wcet;
  for (const std::int64_t tenths : {9, 8, 7, 6, 5}) {
    if (now == Duration::zero()) break;
    family.push_back({{{Change::Kind::work, devices, {}, {}, tenths * 100}},
                      fmt::format("execution times {} % shorter for {}", 100 - tenths * 10, who)});
  }
  return family;
}

std::vector<Remedy> processor_remedies(const Timing& timing, Trials& trials) {
  const Goal goal{[](const Timing& t) { return t.schedulable ? 0.0 : t.processor_load; }, 0};
  const std::vector<Family> by_settings = settings(timing);
  std::vector<Family> all = by_settings;
  for (Family& family : work(timing)) all.push_back(std::move(family));
  std::vector<Remedy> found = trials.find(all, goal);
  if (!found.empty() && found.front().enough) return found;
  if (auto together = find_together(trials, by_settings, goal)) return {*together};
  return found;
}

std::string processor_hint(const Timing& timing, const Remedy& remedy) {
  if (remedy.enough)
    return fmt::format("{}: every deadline is met, the processor needs {}", remedy.proposal.text,
                       percent(remedy.processor_load));
  return fmt::format("{} brings the processor from {} to {}, which is not enough alone", remedy.proposal.text,
                     percent(timing.processor_load), percent(remedy.processor_load));
}

}  // namespace finemote::gen::timing
