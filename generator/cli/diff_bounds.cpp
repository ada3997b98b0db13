#include "generator/cli/diff_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/bus/bus_type.hpp"
#include "generator/model/streamed_frames.hpp"
#include "generator/timing/table.hpp"
#include "generator/timing/words.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

const char* yes_or_no(bool is_yes) { return is_yes ? "yes" : "no"; }

void add_requirement_bounds(const timing::Timing& timing, Facts& facts) {
  for (const timing::RequirementResult& result : timing.requirements) {
    auto& bounds = facts[fmt::format("bounds of '{}'", result.requirement.text)];
    const bool is_known = bounds.count("requirements hold") != 0;
    const bool holds = result.ok && (!is_known || bounds["requirements hold"] == yes_or_no(true));
    bounds["requirements hold"] = yes_or_no(holds);
    if (result.value) bounds["value"] = timing::duration_text(result.value);
  }
}

/// Of every end the chain with the oldest data; one without a bound is older than any other. Requirements name further
/// ones.
std::map<Rank, const timing::ChainResult*> worst_chains(const timing::Timing& timing) {
  const auto is_older = [](const timing::ChainResult& a, const timing::ChainResult& b) {
    return b.end_to_end && (!a.end_to_end || *a.end_to_end > *b.end_to_end);
  };
  std::map<Rank, const timing::ChainResult*> worst;
  for (const timing::ChainResult& chain : timing.chains) {
    const timing::ChainResult*& known = worst[chain.to];
    if (known == nullptr || is_older(chain, *known)) known = &chain;
  }
  return worst;
}

}  // namespace

void add_bounds(const Analysis& analysis, Facts& facts) {
  auto& robot = facts["bounds of the robot"];
  robot["answered"] = yes_or_no(analysis.timing.has_value());
  if (!analysis.timing) return;
  const timing::Timing& timing = *analysis.timing;
  robot["schedulable"] = yes_or_no(timing.schedulable);
  robot["processor load"] = timing::percent(timing.processor_load);
  for (const timing::BucketResult& bucket : timing.verdict().buckets)
    facts[fmt::format("bounds of bucket '{}'", units::spaced_duration(bucket.period))]["response"] =
        timing::duration_text(bucket.response);
  for (const timing::BusPlace bus : timing.bus_loads.ids())
    facts[fmt::format("bounds of bus '{}'", timing.model.buses[bus].name)]["load"] =
        timing::percent(timing.bus_loads[bus].utilization);
  for (const auto& [to, worst] : worst_chains(timing)) {
    const timing::ChainResult& chain = *worst;
    auto& bounds = facts[fmt::format("bounds of the command of '{}'", timing.model.devices[to].name)];
    bounds["oldest data from"] = timing.model.devices[chain.from].name;
    bounds["decide"] = timing::duration_text(chain.decide);
    bounds["end to end"] = timing::duration_text(chain.end_to_end);
  }
  add_requirement_bounds(timing, facts);
}

void add_sizes(const PlannedRobot& planned, const std::vector<OutputFile>& files, Facts& facts) {
  const auto& crossings = planned.schedule.crossings;
  const auto latches = std::count_if(crossings.begin(), crossings.end(),
                                     [](const Crossing& crossing) { return crossing.kind != Crossing::Kind::copy; });
  std::int64_t rings = 0;
  for (const BusId bus : planned.robot.buses.ids()) {
    const bool has_ring = bus_type(planned.robot.buses[bus].kind).port_class == PortClass::uart;
    if (has_ring) rings += receive_ring(planned.robot, bus);
  }
  std::ptrdiff_t lines = 0;
  for (const OutputFile& file : files) lines += std::count(file.text.begin(), file.text.end(), '\n');
  facts["size of what is generated"] = {{"files", std::to_string(files.size())},
                                        {"lines", std::to_string(lines)},
                                        {"latches between buckets", std::to_string(latches)},
                                        {"transfer slots", std::to_string(planned.schedule.slots.size())},
                                        {"bytes of receive rings", std::to_string(rings)}};
}

}  // namespace finemote::gen
