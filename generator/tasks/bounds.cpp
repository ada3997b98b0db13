#include "generator/tasks/bounds.hpp"

#include "generator/tasks/from_robot.hpp"

namespace finemote::gen::timing {
namespace {

/// @param inputs  those of the timing whose ages are meant
RobotBounds bounds_of(const std::optional<Timing>& timing, std::vector<ChainResult> Timing::*inputs,
                      const Forest& forest, const Schedule& schedule) {
  RobotBounds bounds{Table<DeviceId, DeviceBounds>(forest.order.size()),
                     std::vector<std::optional<Duration>>(schedule.buckets.size()), false};
  if (!timing || !timing->target) return bounds;
  bounds.answered = true;
  const ProfileResult& target = *timing->target;
  for (const Rank d : target.devices.ids()) {
    bounds.devices[forest.order[d]].response = target.devices[d].r_minus;
    bounds.devices[forest.order[d]].wait = timing->frame_waits[d];
  }
  for (std::size_t w = 0; w < target.buckets.size(); ++w) bounds.jobs[w] = target.buckets[w].response;
  for (const ChainResult& input : (*timing).*inputs) {
    DeviceBounds& device = bounds.devices[forest.order[input.to]];
    device.has_input = true;
    device.oldest = forest.order[input.from];
    device.age = input.age;
    device.output = input.end_to_end;
  }
  return bounds;
}

}  // namespace

RobotBounds robot_bounds(const std::optional<Timing>& timing, const Forest& forest, const Schedule& schedule) {
  return bounds_of(timing, &Timing::inputs, forest, schedule);
}

RobotBounds instrumented_bounds(const Robot& robot, const Forest& forest, const Schedule& schedule) {
  RobotTimingOptions instrumented;
  instrumented.trace = instrumented.monitor = true;
  AnalysisRequest request;
  request.inputs = true;
  Diagnostics nobody_asks;  // the robot is judged without them
  const auto model = make_timing_model(robot, forest, schedule, nobody_asks, instrumented);
  return bounds_of(model ? analyse(*model, request, nobody_asks) : std::nullopt, &Timing::stamped_inputs, forest,
                   schedule);
}

}  // namespace finemote::gen::timing
