#include "generator/cli/verdict.hpp"

#include <algorithm>

#include "generator/timing/remodel.hpp"

namespace finemote::gen {
namespace {

/// Load per bus of the robot, found by name: the model has the physical buses with a rate only.
Table<BusId, double> bus_loads(const Robot& robot, const timing::Timing& timing) {
  Table<BusId, double> loads(robot.buses.size(), 0.0);
  for (std::size_t i = 0; i < timing.model.buses.size() && i < timing.bus_loads.size(); ++i) {
    for (const BusId bus : robot.buses.ids()) {
      if (robot.buses[bus].name.text == timing.model.buses[i].name) loads[bus] = timing.bus_loads[i].utilization;
    }
  }
  return loads;
}

Table<DeviceId, std::optional<CommandAge>> command_ages(const Loaded& loaded, const timing::Timing& timing) {
  Table<DeviceId, std::optional<CommandAge>> ages(loaded.robot.devices.size());
  for (const timing::ChainResult& input : timing.inputs) {
    if (!input.acquire_ns || !input.decide_ns) continue;
    ages[loaded.forest.order[Rank{input.to}]] = {*input.acquire_ns + *input.decide_ns,
                                                 loaded.forest.order[Rank{input.from}]};
  }
  return ages;
}

}  // namespace

std::optional<Verdict> timing_verdict(Context& context, const Loaded& loaded, CommandAges ages) {
  timing::AnalysisRequest request;
  request.requirements = timing::timing_requirements(loaded.robot, loaded.forest);
  request.inputs = ages == CommandAges::needed;
  request.remodel = timing::robot_remodel(loaded.robot, loaded.forest);
  Diagnostics findings;
  const auto timing =
      timing::analyse(timing::make_timing_model(loaded.robot, loaded.forest, loaded.schedule), request, findings);
  if (!timing) {
    for (const Diagnostic& finding : findings.in_file_order()) {
      if (finding.severity == Severity::error) context.diagnostics.error(finding.code, finding.at, finding.message);
    }
    return std::nullopt;
  }
  Verdict verdict;
  verdict.schedulable = timing->schedulable;
  verdict.requirements_hold = timing->requirements_hold();
  verdict.bus_load = bus_loads(loaded.robot, *timing);
  verdict.command_ages = command_ages(loaded, *timing);
  Diagnostics reasons;
  for (const Diagnostic& finding : findings.in_file_order()) {
    if (finding.code == code::timing_bus_overload)
      verdict.overloads.push_back(finding);
    else
      reasons.add(finding);
  }
  if (reasons.has_errors()) verdict.reasons = std::move(reasons);
  return verdict;
}

}  // namespace finemote::gen
