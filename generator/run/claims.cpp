#include "generator/run/claims.hpp"

#include "generator/run/samples.hpp"

namespace finemote::gen {
namespace {

/// What its data may be old by their time stamp when its update() begins.
std::optional<Duration> oldest_claim(const Forest& forest, const timing::Timing& timing, DeviceId device) {
  for (const Rank d : timing.stamped_ages.ids()) {
    if (forest.order[d] == device) return timing.stamped_ages[d];
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
        {device, {summarize(leads), kClaimSlack}, {summarize(ages), oldest_claim(forest, timing, device)}});
  }
  return claims;
}

}  // namespace finemote::gen
