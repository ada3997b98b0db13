// Robot to what its firmware can be held to: how late every handle() ends, and how old the data behind its command is.
#pragma once

#include "generator/forest/forest.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// Of one device; without a value there is no bound, or nothing to bound. Ages are true ones, but for those of a
/// monitor, which knows time stamps alone.
struct DeviceBounds {
  std::optional<Duration> response;  ///< release to end of handle()
  bool has_input = false;            ///< it takes its command from another device
  std::optional<Duration> age;       ///< oldest sample behind that command, at the end of handle()
  std::optional<Duration> output;    ///< the same sample, at the last bit of the output
  std::optional<DeviceId> oldest;    ///< whose sample
  std::optional<Duration> wait;      ///< of frames that arrive from its part, see timing/frame_waits.hpp
};

struct RobotBounds {
  Table<DeviceId, DeviceBounds> devices;
  std::vector<std::optional<Duration>> jobs;  ///< per Schedule::buckets: release to end of a job
  bool answered = false;                      ///< the analysis came to an end
};

/// The bounds of profile `target`, of an analysis that was asked for `inputs`. Never fails: what it did not answer has
/// no bound.
RobotBounds robot_bounds(const std::optional<Timing>& timing, const Forest& forest, const Schedule& schedule);

/// The same of the firmware with monitor and trace built in, which is analysed for it; ages by their time stamps, which
/// is what the monitor knows.
RobotBounds instrumented_bounds(const Robot& robot, const Forest& forest, const Schedule& schedule);

}  // namespace finemote::gen::timing
