#include "generator/run/samples.hpp"

#include <algorithm>
#include <map>

#include "generator/forest/stage.hpp"

namespace finemote::gen {
namespace {

/// When the samples of a part were taken, by channel and number.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> samples_of(const RunRecord& record,
                                                                           const std::string& part) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> samples;
  for (const PartRecord& event : record.parts) {
    if (!event.is_output && event.part == part) samples.emplace(std::pair(event.channel, event.n), event.from_ps);
  }
  return samples;
}

}  // namespace

std::vector<SampledState> states_of(const Robot& robot, const Forest& forest, const RunRecord& record,
                                    DeviceId device) {
  const std::string& name = robot.devices[device].name.text;
  const auto samples = samples_of(record, name);
  const std::uint32_t update = Stage{forest.rank[device], false}.number();
  std::vector<SampledState> states;
  for (const SampleUse& use : record.uses) {
    const auto sample = samples.find({use.channel, use.n});
    if (use.stage != update || use.part != name || sample == samples.end()) continue;
    if (states.empty() || states.back().at_ps != use.at_ps) {
      states.push_back({use.at_ps, sample->second, use.claimed_ps});
    } else {
      states.back().from_ps = std::min(states.back().from_ps, sample->second);
    }
  }
  return states;
}

}  // namespace finemote::gen
