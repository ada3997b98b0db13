#include "generator/run/claims.hpp"

#include "generator/run/samples.hpp"

namespace finemote::gen {

std::vector<MeasuredClaim> measure_claims(const Robot& robot, const Forest& forest, const RunRecord& record) {
  std::vector<MeasuredClaim> claims;
  for (const DeviceId device : forest.order) {
    if (!robot.devices[device].type->acquisition) continue;
    std::vector<Duration> leads;
    for (const SampledState& state : states_of(robot, forest, record, device)) {
      if (state.claimed_ps && state.at() >= record.ready)
        leads.push_back(record.true_time(picoseconds_up(*state.claimed_ps - state.from_ps)));
    }
    claims.push_back({device, {summarize(leads), kClaimSlack}});
  }
  return claims;
}

}  // namespace finemote::gen
