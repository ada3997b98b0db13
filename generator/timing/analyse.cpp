#include "generator/timing/analyse.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/timing/explain.hpp"
#include "generator/timing/frame_waits.hpp"
#include "generator/timing/operands.hpp"
#include "generator/timing/shares.hpp"
#include "generator/timing/stamps.hpp"
#include "generator/timing/table.hpp"
#include "generator/timing/true_time.hpp"
#include "generator/timing/unbounded.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

/// Least time that a job of `devices` takes to the end of handle() of one of them.
Duration least_time(const Model& model, const std::vector<Rank>& devices, Rank device) {
  Duration least;
  for (const Rank d : devices) {
    least += model.devices[d].update_bcet;
    if (d >= device) least += model.devices[d].handle_bcet;
  }
  return least;
}

/// A requirement that needs no chain: utilization and jitter.
RequirementResult evaluate_load(const Model& model, const ProfileAnalysis& profile,
                                const Table<BusPlace, BusLoad>& loads, const Requirement& r) {
  RequirementResult result;
  result.requirement = r;
  if (r.kind == Requirement::Kind::utilization) {
    if (r.bus && !undeclared_text(model, *r.bus).empty()) return result;
    result.fraction = r.bus ? loads[*r.bus].utilization : processor_share(profile.set);
    result.ok = *result.fraction <= r.max_fraction;
    return result;
  }
  result.value = jitter_bound(model, profile.result, r.to.front());
  result.ok = result.value && *result.value <= r.max;
  return result;
}

class Evaluation {
 public:
  Evaluation(const Model& model, const ProfileAnalysis& profile, const ChainAnalysis& chains,
             const Table<BusPlace, BusLoad>& loads)
      : model_(model), profile_(profile), chains_(chains), loads_(loads) {}

  RequirementResult evaluate(const Requirement& r) const {
    if (!r.is_latency()) return evaluate_load(model_, profile_, loads_, r);
    RequirementResult result;
    result.requirement = r;
    find_latency(r, result);
    result.ok = result.value && *result.value <= r.max;
    return result;
  }

 private:
  /// The largest of all pairs; none when one of them has none.
  void find_latency(const Requirement& r, RequirementResult& result) const {
    const auto value_of = [&](const ChainResult& chain) {
      return r.kind == Requirement::Kind::latency_decision ? chain.decide : chain.end_to_end;
    };
    Duration worst, decide;
    bool decides = true;
    for (const Rank from : r.from) {
      for (const Rank to : r.to) {
        if (!chains_.connected(from, to)) {
          result.unconnected = ChainRequest{from, to};
          result.connected_backwards = chains_.connected(to, from);
          return;
        }
        const ChainResult chain = chains_.bound(from, to);
        decides &= chain.decide.has_value();
        decide = std::max(decide, chain.decide.value_or(Duration::zero()));
        const auto value = value_of(chain);
        const bool is_worst = !result.chain || (value_of(*result.chain) && (!value || *value > worst));
        if (is_worst) result.chain = chain;
        worst = std::max(worst, value.value_or(Duration::zero()));
      }
    }
    if (decides) result.decide = decide;
    if (result.chain && value_of(*result.chain)) result.value = worst;
  }

  const Model& model_;
  const ProfileAnalysis& profile_;
  const ChainAnalysis& chains_;
  const Table<BusPlace, BusLoad>& loads_;
};

/// The assumed figures as what they become when they are written down: a budget to keep.
std::string wcet_hint(const Device& device) {
  return fmt::format(
      "<wcet update=\"{}\" handle=\"{}\" source=\"budget\"/> at '{}' if it never takes longer; finemote run prints "
      "the element with source=\"measured\"",
      units::format_duration(device.update_wcet), units::format_duration(device.handle_wcet), device.name);
}

constexpr std::size_t kMostNamed = 6;

/// Devices with such a bound: their own, of the path of a leaf, or of a chain to them.
std::vector<Rank> with_closed_form(const Timing& timing) {
  Table<Rank, bool> has_one(timing.model.devices.size());
  for (const BucketResult& bucket : timing.verdict().buckets) {
    for (const Rank d : bucket.devices) has_one[d] = bucket.closed_form || timing.verdict().devices[d].closed_form;
  }
  for (const TreeResult& tree : timing.verdict().trees) {
    if (tree.closed_form) has_one[tree.root] = true;
    for (const PathResult& path : tree.paths) has_one[path.leaf] = has_one[path.leaf] || path.closed_form;
  }
  for (const ChainResult& chain : timing.chains) has_one[chain.to] = has_one[chain.to] || chain.closed_form;
  std::vector<Rank> closed;
  for (const Rank d : has_one.ids()) {
    if (has_one[d]) closed.push_back(d);
  }
  return closed;
}

std::string stage_text(const char* stage, const std::optional<Duration>& computed) {
  return fmt::format("{}() at most {}", stage, duration_text(computed));
}

/// FM4024 of every device that the image can take longer than the user declares.
void report_declared(const Timing& timing, Diagnostics& diagnostics) {
  for (const Rank d : timing.above_declared) {
    const Device& device = timing.model.devices[d];
    diagnostics
        .error(code::timing_above_declared, device.at,
               fmt::format("the image can take longer than the <wcet> of '{}' declares", device.name))
        .note(fmt::format("bounds of the image: {}, {}", stage_text("update", device.update_static),
                          stage_text("handle", device.handle_static)))
        .hint(fmt::format("<wcet update=\"{}\" handle=\"{}\" source=\"budget\"/>, or make the code faster",
                          units::format_duration(device.update_wcet), units::format_duration(device.handle_wcet)));
  }
}

void report_remarks(const Timing& timing, Diagnostics& diagnostics) {
  const std::vector<Rank> closed = with_closed_form(timing);
  if (!closed.empty()) {
    diagnostics
        .warning(code::timing_closed_form, timing.model.devices[closed.front()].at,
                 "there are too many releases to examine every one: some bounds are safe closed forms")
        .note("of " + quoted_names(timing.model, closed, kMostNamed));
  }
  if (!timing.assumed.empty()) {
    diagnostics
        .warning(code::timing_assumed, timing.model.devices[timing.assumed.front()].at,
                 fmt::format("execution times of {} are assumed",
                             timing.assumed.size() == 1 ? std::string("one device")
                                                        : fmt::format("{} devices", timing.assumed.size())))
        .note(quoted_names(timing.model, timing.assumed, kMostNamed))
        .hint(wcet_hint(timing.model.devices[timing.assumed.front()]));
  }
}

/// The chains a user named: on the command line, and by requirements.
std::vector<ChainRequest> asked_chains(const AnalysisRequest& request, const std::vector<Requirement>& requirements) {
  std::vector<ChainRequest> chains = request.chains;
  for (const Requirement& requirement : requirements) {
    if (!requirement.is_latency()) continue;
    for (const Rank from : requirement.from) {
      for (const Rank to : requirement.to) chains.push_back({from, to});
    }
  }
  return chains;
}

bool is_among(const std::vector<ChainResult>& chains, Rank from, Rank to) {
  return std::any_of(chains.begin(), chains.end(),
                     [&](const ChainResult& chain) { return chain.from == from && chain.to == to; });
}

/// Adds a chain that is not there yet and that data can take.
void add_chain(const ChainAnalysis& analysis, const ChainRequest& wanted, std::vector<ChainResult>& chains) {
  const bool known = is_among(chains, wanted.from, wanted.to);
  if (!known && analysis.connected(wanted.from, wanted.to)) chains.push_back(analysis.bound(wanted.from, wanted.to));
}

/// A requirement that was not judged: it stands for itself in the list, and fails nothing.
RequirementResult left_open(const Requirement& r) {
  RequirementResult result;
  result.requirement = r;
  result.ok = true;
  return result;
}

/// What a hint on deadlines and loads needs to know of a changed model; requirements on latencies are not judged.
Timing analyse_verdict(const Model& model, const AnalysisRequest& request) {
  Timing timing;
  timing.asked = request.profile.value_or(best_profile(model));
  ProfileAnalysis asked = analyse_deadlines(model, timing.asked, request.limits);
  // Loads and jitter are those of the best profile, whichever is asked for.
  const Profile of_loads = best_profile(model);
  std::optional<ProfileAnalysis> other;
  if (of_loads != timing.asked) other = analyse_deadlines(model, of_loads, request.limits);
  const ProfileAnalysis& best = other ? *other : asked;
  Effort effort(request.limits.steps, best.most_releases);
  timing.bus_loads = WireAnalysis(model, best, effort).loads();
  timing.processor_load = processor_share(asked.set);
  timing.schedulable = asked.result.schedulable;
  for (const Requirement& r : request.requirements) {
    timing.requirements.push_back(r.is_latency() ? left_open(r) : evaluate_load(model, best, timing.bus_loads, r));
  }
  return timing;
}

/// FM4018 of every chain that leads nowhere.
void report_unconnected(const Model& model, const ChainAnalysis& chains, const std::vector<ChainRequest>& asked,
                        Diagnostics& diagnostics) {
  for (const ChainRequest& c : asked) {
    if (chains.connected(c.from, c.to)) continue;
    diagnostics.error(
        code::timing_chain, model.devices[c.from].at,
        fmt::format("no data leads from '{}' to '{}'", model.devices[c.from].name, model.devices[c.to].name));
  }
}

/// Every profile, chains, loads and requirements. Reports FM4018, and nothing of what was found.
std::optional<Timing> analyse_all(const Model& model, const AnalysisRequest& request, Diagnostics& diagnostics) {
  const Topology topology = make_topology(model);
  Timing timing;
  timing.model = model;
  timing.utilization = test_utilization(model);
  ProfileAnalysis paper = analyse_profile(model, topology, Profile::paper, request.limits);
  ProfileAnalysis tight = analyse_profile(model, topology, Profile::tight, request.limits);
  std::optional<ProfileAnalysis> target;
  if (model.has_target) target = analyse_profile(model, topology, Profile::target, request.limits);
  const ProfileAnalysis& best = target ? *target : tight;
  Effort effort(request.limits.steps, best.most_releases);
  const WireAnalysis wire(model, best, effort);
  const SampleAges ages = wire.acquisitions();
  const ChainAnalysis chains(model, topology, best, wire, ages, effort);
  timing.chains = chains.defaults();
  Effort of_stamps(request.limits.steps, best.most_releases);  // so that they do not cost chains their exactness
  timing.frame_waits = frame_waits(model, wire.transfers(), of_stamps);
  const SampleAges stamped = stamped_ages(model, best.set, ages, timing.frame_waits, of_stamps);
  for (const auto& age : stamped) timing.stamped_ages.push_back(true_bound(model, age));
  if (request.inputs) {
    timing.inputs = chains.oldest_inputs();
    timing.stamped_inputs = timing.inputs;
    if (!std::equal(ages.begin(), ages.end(), stamped.begin()))
      timing.stamped_inputs = ChainAnalysis(model, topology, best, wire, stamped, of_stamps).oldest_inputs();
  }
  report_unconnected(model, chains, request.chains, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const std::vector<Requirement> requirements = reach_actuators(request.requirements, model, topology);
  for (const ChainRequest& c : asked_chains(request, requirements)) add_chain(chains, c, timing.chains);
  if (request.every) {
    timing.others = chains.every();
    std::erase_if(timing.others, [&](const ChainResult& c) { return is_among(timing.chains, c.from, c.to); });
  }
  const Evaluation evaluation(model, best, chains, wire.loads());
  if (!request.chains_alone) {
    for (const Requirement& r : requirements) timing.requirements.push_back(evaluation.evaluate(r));
  }
  timing.bus_loads = wire.loads();
  for (const Rank d : model.devices.ids()) {
    if (model.devices[d].source == WcetSource::assumed) timing.assumed.push_back(d);
    if (model.devices[d].is_above_declared) timing.above_declared.push_back(d);
  }
  timing.asked = request.profile.value_or(best_profile(model));
  const ProfileAnalysis& asked = timing.asked == Profile::paper   ? paper
                                 : timing.asked == Profile::tight ? tight
                                                                  : *target;
  timing.processor = processor_use(model, asked.set);
  timing.processor_load = processor_share(asked.set);
  timing.paper = std::move(paper.result);
  timing.tight = std::move(tight.result);
  if (target) timing.target = std::move(target->result);
  timing.schedulable = timing.verdict().schedulable;
  return timing;
}

/// Reports what was found, each with hints that were tried, and fills Timing::missing by trials of the same kind.
void report_findings(const AnalysisRequest& request, Timing& timing, Diagnostics& diagnostics) {
  Trials trials(timing, request);
  if (!report_release(timing, diagnostics)) report_buckets(timing, trials, diagnostics);
  report_requirements(timing, trials, diagnostics);
  report_declared(timing, diagnostics);
  timing.missing = missing_bounds(timing, trials);
  report_bus_overloads(timing, trials, diagnostics);
  report_remarks(timing, diagnostics);
}

}  // namespace

bool Timing::requirements_hold() const {
  const auto holds = [](const RequirementResult& r) { return r.ok; };
  return above_declared.empty() && std::all_of(requirements.begin(), requirements.end(), holds);
}

std::optional<Duration> jitter_bound(const Model& model, const ProfileResult& profile, Rank device) {
  const auto response = profile.devices[device].r_minus;
  if (!response) return std::nullopt;
  const auto holds = [&](const BucketResult& bucket) { return bucket.period == model.devices[device].period; };
  const auto bucket = std::find_if(profile.buckets.begin(), profile.buckets.end(), holds);
  return *response - least_time(model, bucket->devices, device);
}

Position at_first_device(const Model& model) { return model.devices.empty() ? Position{} : model.devices[Rank{}].at; }

void report_overflow(const Position& at, const Overflow& overflow, Diagnostics& diagnostics) {
  diagnostics.error(code::timing_overflow, at, fmt::format("{} does not fit signed 64 bits", overflow.what()))
      .note("times are integer nanoseconds, at most 292 years");
}

std::optional<Timing> analyse(const Model& model, const AnalysisRequest& request, Diagnostics& diagnostics) {
  if (request.profile == Profile::target && !model.has_target) {
    diagnostics
        .error(code::timing_profile, at_first_device(model), "profile 'target' needs costs, and this model has none")
        .hint("add 'costs' to the model, or ask for profile tight");
    return std::nullopt;
  }
  try {
    if (request.verdict_only) return analyse_verdict(model, request);
    std::optional<Timing> timing = analyse_all(model, request, diagnostics);
    if (timing) report_findings(request, *timing, diagnostics);
    return timing;
  } catch (const Overflow& overflow) {
    report_overflow(at_first_device(model), overflow, diagnostics);
  }
  return std::nullopt;
}

}  // namespace finemote::gen::timing
