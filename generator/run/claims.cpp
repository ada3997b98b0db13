#include "generator/run/claims.hpp"

#include "generator/bus/bus_type.hpp"
#include "generator/run/samples.hpp"

namespace finemote::gen {
namespace {

/// What its data may be old when its update() begins; none where a time stamp says more.
std::optional<Duration> oldest_claim(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                     DeviceId device) {
  const Device& one = robot.devices[device];
  const bool is_arbitrated = one.segment && bus_type(robot.segments[*one.segment].bus_kind).is_arbitrated;
  if (is_arbitrated) return std::nullopt;
  for (const auto* chains : {&timing.chains, &timing.others}) {
    for (const timing::ChainResult& chain : *chains) {
      if (forest.order[chain.from] == device) return chain.acquire;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<MeasuredClaim> measure_claims(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                          const RunRecord& record, const StageRuns& runs) {
  std::vector<MeasuredClaim> claims;
  for (const DeviceId device : forest.order) {
    if (!robot.devices[device].type->acquisition) continue;
    std::vector<Duration> leads, ages;
    for (const SampledState& state : states_of(robot, forest, record, device)) {
      if (!state.claimed_ps || state.at() < record.ready) continue;
      leads.push_back(record.true_time(picoseconds_up(*state.claimed_ps - state.from_ps)));
      const StageRun* update = ended_at(runs.of(device, false), state.at());
      if (update != nullptr && update->begin >= record.ready)
        ages.push_back(record.true_time(update->begin - picoseconds_up(*state.claimed_ps)));
    }
    claims.push_back(
        {device, {summarize(leads), kClaimSlack}, {summarize(ages), oldest_claim(robot, forest, timing, device)}});
  }
  return claims;
}

}  // namespace finemote::gen
