#include "generator/run/run_result.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "generator/bus/bus_type.hpp"
#include "generator/run/violation.hpp"

namespace finemote::gen {

std::uint64_t RunResult::violations() const {
  std::uint64_t count = 0;
  for (const MonitorEntry& entry : record.monitor) count += entry.response_violations + entry.age_violations;
  return count;
}

std::uint64_t RunResult::overruns() const {
  return std::accumulate(record.overruns.begin(), record.overruns.end(), std::uint64_t{0});
}

namespace {

/// Of a figure that has a bound.
struct Judged {
  Judgement judgement;
  Journey journey;
};

std::vector<Judged> judgements(const RunResult& result) {
  std::vector<Judged> all;
  for (const MeasuredChain& chain : result.figures.chains) {
    for (const auto& [name, figure] : kChainFigures)
      all.push_back({(chain.*figure).judged(), journey_of(chain, figure)});
  }
  for (const MeasuredResponse& response : result.figures.responses) {
    for (const auto& [name, figure] : kResponseFigures) all.push_back({(response.*figure).judged(), {}});
  }
  return all;
}

bool has(const std::vector<Judged>& all, Judgement one) {
  return std::any_of(all.begin(), all.end(), [&](const Judged& judged) { return judged.judgement == one; });
}

/// Broken although nothing that the scenario does takes the ground from its bound.
bool is_wrong(const RunResult& result, const Judged& judged) {
  return judged.judgement == Judgement::broken &&
         !violated_assumption(result.robot, result.record.violated, judged.journey);
}

}  // namespace

bool RunResult::bounds_hold() const {
  const std::vector<Judged> all = judgements(*this);
  const bool is_monitored_well = violations() == 0 || !record.violated.empty();
  return is_monitored_well && std::none_of(all.begin(), all.end(), [&](const Judged& j) { return is_wrong(*this, j); });
}

bool RunResult::claims_hold() const {
  return std::none_of(figures.claims.begin(), figures.claims.end(), [&](const MeasuredClaim& claim) {
    return is_wrong(*this, {claim.lead.judged(), {claim.device, {}}});
  });
}

bool RunResult::is_judged() const {
  const std::vector<Judged> all = judgements(*this);
  return has(all, Judgement::held) || has(all, Judgement::broken);
}

bool RunResult::is_all_judged() const {
  const std::vector<Judged> all = judgements(*this);
  return is_judged() && !has(all, Judgement::no_sample) && !has(all, Judgement::no_bound);
}

std::vector<FaultCount> RunResult::unexplained_faults() const {
  std::set<std::string> silent;  // kinds of buses that a part without a model sits on, by which modules are called
  for (const Device& device : robot.devices) {
    const bool is_silent =
        std::find(record.silent.begin(), record.silent.end(), device.name.text) != record.silent.end();
    if (is_silent && device.segment) silent.emplace(bus_type(robot.segments[*device.segment].bus_kind).name);
  }
  std::vector<FaultCount> faults;
  for (const FaultCount& fault : record.late_faults) {
    const FaultMeaning* meaning = meaning_of(fault_table, fault);
    if (meaning == nullptr || silent.count(meaning->module_name) == 0) faults.push_back(fault);
  }
  return record.violated.empty() ? faults : std::vector<FaultCount>{};
}

bool RunResult::good() const {
  const auto& expected = record.expectations;
  const bool as_expected =
      std::all_of(expected.begin(), expected.end(), [](const ExpectationRecord& e) { return e.ok; });
  if (must_judge && !is_judged()) return false;
  if (order.mistake || !unexplained_faults().empty()) return false;
  return overruns() == 0 && record.resets == 0 && wcets_hold && loops_hold && traffic_holds && as_expected &&
         bounds_hold() && claims_hold();
}

const std::string& name_of(const RunResult& result, DeviceId device) { return result.robot.devices[device].name.text; }

}  // namespace finemote::gen
