#include "generator/run/claims.hpp"

#include "generator/run/samples.hpp"

namespace finemote::gen {
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
        {device, {summarize(leads), kClaimSlack}, {summarize(ages), timing.stamped_ages[forest.rank[device]]}});
  }
  return claims;
}

}  // namespace finemote::gen
