#include "generator/run/reached_outputs.hpp"

#include "generator/forest/stage.hpp"

namespace finemote::gen {
namespace {

/// Where a device's output can be seen: at its own part, or at a channel of the part it drives.
struct OutputPlace {
  std::string part;
  std::optional<std::uint32_t> channel = {};  ///< none: any

  [[nodiscard]] bool has(const PartRecord& event) const {
    return event.is_output && event.part == part && (!channel || event.channel == *channel);
  }
};

OutputPlace output_of(const Robot& robot, const Device& device) {
  const Segment* segment = device.segment ? &robot.segments[*device.segment] : nullptr;
  if (segment == nullptr || segment->kind != Segment::Kind::pwm_expander) return {device.name.text};
  return {robot.expanders[*segment->expander].name.text, device.channel.value_or(0)};
}

}  // namespace

ReachedOutputs::ReachedOutputs(const Robot& robot, const Forest& forest, const RunRecord& record, DeviceId device) {
  const OutputPlace place = output_of(robot, robot.devices[device]);
  const std::uint32_t handle = Stage{forest.rank[device], true}.number();
  for (const PartRecord& event : record.parts) {
    if (event.stage != handle || !place.has(event)) continue;
    if (!event.is_repeated) own_.emplace(event.n, event.at());
    any_.emplace(event.n, event.at());
  }
  for (const JobRun& given : record.handed_over) {
    if (given.stage == handle) handed_over_.insert(given.n);
  }
}

std::optional<Duration> ReachedOutputs::of(std::uint32_t run) const {
  const auto found = own_.find(run);
  return found == own_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Duration> ReachedOutputs::overtaken(std::uint32_t run) const {
  if (handed_over_.count(run) == 0) return std::nullopt;
  const auto later = any_.lower_bound(run);
  return later == any_.end() ? std::nullopt : std::optional(later->second);
}

bool ReachedOutputs::is_awaited(std::uint32_t run) const {
  return handed_over_.count(run) != 0 && !any_.empty() && any_.rbegin()->first < run;
}

}  // namespace finemote::gen
