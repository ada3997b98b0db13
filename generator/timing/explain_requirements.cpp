// FM4016: why a requirement fails, what would help, and what would hold.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/timing/explain.hpp"
#include "generator/timing/explain_chain.hpp"
#include "generator/timing/shares.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen::timing {
namespace {

using units::readable_duration;

constexpr std::size_t kMostChanges = 4;

std::string without_zeros(std::string text) {
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Percent, rounded up to `digits` places, so far that reading it again gives no less than `fraction`.
std::string percent_text(double fraction, int digits = 2) {
  const double places = std::pow(10, digits);
  return without_zeros(fmt::format("{:.{}f}", std::ceil(fraction * 100 * places) / places, digits)) + "%";
}

/// Percent as it was written: nobody writes more than ten places.
std::string exact_percent(double fraction) { return without_zeros(fmt::format("{:.10f}", fraction * 100)) + "%"; }

/// Percent with as many places as show that it is above `max`.
std::string percent_above(double fraction, double max) {
  int digits = 2;
  while (digits < 10 && std::ceil(fraction * 100 * std::pow(10, digits)) / std::pow(10, digits) <= max * 100) ++digits;
  return percent_text(fraction, digits);
}

const char* subject(Requirement::Kind kind) {
  switch (kind) {
    case Requirement::Kind::latency_end_to_end:
      return "latency";
    case Requirement::Kind::latency_decision:
      return "decision latency";
    case Requirement::Kind::utilization:
      return "utilization";
    case Requirement::Kind::jitter:
      return "jitter";
  }
  return "";
}

std::string message_of(const RequirementResult& r) {
  const std::string what = fmt::format("{} of '{}'", subject(r.requirement.kind), r.requirement.text);
  if (r.fraction) {
    return fmt::format("{} is up to {}, above its max of {}", what,
                       percent_above(*r.fraction, r.requirement.max_fraction),
                       exact_percent(r.requirement.max_fraction));
  }
  if (r.requirement.kind == Requirement::Kind::utilization)
    return fmt::format("{} has no bound, its max is {}", what, exact_percent(r.requirement.max_fraction));
  const std::string max = readable_duration(r.requirement.max);
  return r.value ? fmt::format("{} is up to {}, above its max of {}", what, readable_duration(*r.value), max)
                 : fmt::format("{} has no bound, its max is {}", what, max);
}

void explain_utilization(const Timing& timing, const RequirementResult& r, Diagnostic& finding) {
  std::vector<Share> shares;
  if (r.requirement.bus && !r.fraction) {
    finding.note(undeclared_text(timing.model, *r.requirement.bus));
    return;
  }
  if (r.requirement.bus) {
    finding.note(shares_text(bus_shares(timing.model, *r.requirement.bus)));
    return;
  }
  double devices = 0;
  for (const Device& device : timing.model.devices) {
    const double load = ratio(device.update_wcet + device.handle_wcet, device.period);
    add_share(shares, quoted(device.name), load, false);
    devices += load;
  }
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.load > b.load; });
  finding.note(shares_text(shares));
  const double others = *r.fraction - devices;
  finding.note(fmt::format("interrupts of buses, releases and copies take {}", percent(others)));
}

void explain(const Timing& timing, const RequirementResult& r, Diagnostic& finding) {
  using Kind = Requirement::Kind;
  if (r.unconnected) {
    finding.note(fmt::format("no data leads from '{}' to '{}'", timing.model.devices[r.unconnected->from].name,
                             timing.model.devices[r.unconnected->to].name));
    finding.hint(r.connected_backwards ? "write it the other way round, or join their trees with <reads>"
                                       : "join their trees with <reads>");
    return;
  }
  if (r.requirement.kind == Kind::utilization) return explain_utilization(timing, r, finding);
  if (r.requirement.kind == Kind::jitter) {
    finding.note("jitter is from the earliest to the latest end of its handle() after a release");
    return;
  }
  if (!r.chain) return;
  explain_chain(timing, *r.chain, r.requirement.kind == Kind::latency_decision, finding);
  const bool decision_holds =
      r.requirement.kind == Kind::latency_end_to_end && r.decide && *r.decide <= r.requirement.max;
  if (decision_holds) {
    finding.hint(fmt::format("of=\"decision\" holds: update of the one to handle of the other takes {}",
                             readable_duration(*r.decide)));
  }
}

/// What the hints of a failing requirement are looked for among: periods and rates on the way of its worst chain, what
/// else runs, and its busiest device.
class RequirementFamilies {
 public:
  RequirementFamilies(const Timing& timing, const RequirementResult& r) : timing_(timing), model_(timing.model) {
    using Kind = Requirement::Kind;
    if (r.requirement.kind == Kind::utilization && r.requirement.bus) {
      add(longer_periods(model_, periodic_users(model_, *r.requirement.bus), "what sends on it"));
      add(faster_rates(model_, *r.requirement.bus));
      add(other_bus(model_, *r.requirement.bus));
    } else if (r.requirement.kind == Kind::utilization || r.requirement.kind == Kind::jitter) {
      add_less_load(r.requirement.to);
    } else if (r.chain) {
      add_chain(*r.chain);
    }
  }
  [[nodiscard]] const std::vector<Family>& list() const { return list_; }

 private:
  void add(Family family) { list_.push_back(std::move(family)); }

  [[nodiscard]] std::string names(const std::vector<Rank>& devices) const {
    return quoted_names(model_, devices, kMostChanges);
  }

  /// These devices, and what shares an output with them.
  [[nodiscard]] std::vector<Rank> with_their_outputs(std::vector<Rank> devices) const {
    const auto has = [&](Rank d) { return std::find(devices.begin(), devices.end(), d) != devices.end(); };
    for (const Flush& flush : model_.flushes) {
      if (!std::any_of(flush.devices.begin(), flush.devices.end(), has)) continue;
      for (const Rank d : flush.devices) {
        if (!has(d)) devices.push_back(d);
      }
    }
    std::sort(devices.begin(), devices.end());
    return devices;
  }

  void add_chain(const ChainResult& chain) {
    std::vector<Rank> way = devices_between(model_, chain);
    std::sort(way.begin(), way.end());
    way.erase(std::unique(way.begin(), way.end()), way.end());
    Duration slowest;
    for (const Rank d : way) slowest = std::max(slowest, model_.devices[d].period);
    std::vector<Rank> slow;
    for (const Rank d : way) {
      if (model_.devices[d].period == slowest) slow.push_back(d);
    }
    slow = with_their_outputs(slow);
    add(shorter_periods(model_, slow, names(slow)));
    if (model_.devices[chain.from].period != slowest || slow.size() > 1)
      add(shorter_periods(model_, {chain.from}, names({chain.from})));
    for (const auto bus : {sample_bus(model_, chain.from), command_bus(model_, chain.to)}) {
      if (!bus) continue;
      add(faster_rates(model_, *bus));
      add(other_bus(model_, *bus));
      if (!chain.end_to_end) add(longer_periods(model_, periodic_users(model_, *bus), "what sends on that bus"));
    }
    add_less_load(way);
  }

  /// Longer periods of the buckets that `spared` are not in, slower buses, and less work of the busiest device.
  void add_less_load(const std::vector<Rank>& spared) {
    for (const BucketResult& bucket : timing_.verdict().buckets) {
      const bool is_spared =
          std::any_of(spared.begin(), spared.end(), [&](Rank d) { return model_.devices[d].period == bucket.period; });
      if (is_spared) continue;
      add(longer_periods(model_, bucket.devices, bucket_text(bucket.period)));
    }
    for (const BusPlace b : model_.buses.ids()) add(slower_rates(model_, b));
    Rank busiest;
    const auto load = [&](Rank d) {
      const Device& device = model_.devices[d];
      return ratio(device.update_wcet + device.handle_wcet, device.period);
    };
    for (const Rank d : model_.devices.ids()) {
      if (load(d) > load(busiest)) busiest = d;
    }
    add(less_work(model_, {busiest}, names({busiest})));
  }

  const Timing& timing_;
  const Model& model_;
  std::vector<Family> list_;
};

void add_remedies(const Timing& timing, std::size_t index, Trials& trials, Diagnostic& finding) {
  const RequirementResult& now = timing.requirements[index];
  if (now.unconnected) return;
  const auto value_of = [index](const Timing& t) {
    const RequirementResult& r = t.requirements[index];
    if (r.fraction) return *r.fraction;
    return r.value ? static_cast<double>(r.value->ns()) : std::numeric_limits<double>::infinity();
  };
  const bool is_share = now.requirement.kind == Requirement::Kind::utilization;
  const double max = is_share ? now.requirement.max_fraction : static_cast<double>(now.requirement.max.ns());
  for (const Remedy& remedy :
       trials.find(RequirementFamilies(timing, now).list(), {value_of, max, now.chain.has_value()})) {
    const std::string value =
        is_share ? percent_text(remedy.value) : readable_duration(nanoseconds(static_cast<std::int64_t>(remedy.value)));
    finding.hint(fmt::format("{} brings it to {}{}", remedy.proposal.text, value,
                             remedy.enough ? "" : ", which is not enough alone"));
  }
}

}  // namespace

void report_requirements(const Timing& timing, Trials& trials, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < timing.requirements.size(); ++i) {
    const RequirementResult& r = timing.requirements[i];
    if (r.ok) continue;
    Diagnostic& finding = diagnostics.error(code::timing_requirement, r.requirement.at, message_of(r));
    finding.underline(8);
    explain(timing, r, finding);
    add_remedies(timing, i, trials, finding);
    if (r.value) finding.hint(fmt::format("max=\"{}\" is the smallest that holds today", readable_duration(*r.value)));
    if (r.fraction) finding.hint(fmt::format("max=\"{}\" is the smallest that holds today", percent_text(*r.fraction)));
  }
}

}  // namespace finemote::gen::timing
