#include "generator/timing/bounds.hpp"

namespace finemote::gen::timing {

RobotBounds robot_bounds(const std::optional<Timing>& timing, const Forest& forest, const Schedule& schedule) {
  RobotBounds bounds{Table<DeviceId, DeviceBounds>(forest.order.size()),
                     std::vector<std::optional<Ns>>(schedule.buckets.size()), false};
  if (!timing || !timing->target) return bounds;
  bounds.answered = true;
  const ProfileResult& target = *timing->target;
  for (const Rank d : target.devices.ids()) {
    bounds.devices[forest.order[d]].response_ns = target.devices[d].r_minus_ns;
  }
  for (std::size_t w = 0; w < target.buckets.size(); ++w) bounds.jobs[w] = target.buckets[w].response_ns;
  for (const ChainResult& input : timing->inputs) {
    DeviceBounds& device = bounds.devices[forest.order[input.to]];
    device.has_input = true;
    device.oldest = forest.order[input.from];
    if (!input.acquire_ns || !input.decide_ns) continue;
    device.age_ns = add(*input.acquire_ns, *input.decide_ns);
    if (input.wire_ns) device.output_ns = add(*device.age_ns, *input.wire_ns);
  }
  return bounds;
}

RobotBounds instrumented_bounds(const Robot& robot, const Forest& forest, const Schedule& schedule) {
  RobotTimingOptions instrumented;
  instrumented.trace = instrumented.monitor = true;
  AnalysisRequest request;
  request.inputs = true;
  Diagnostics nobody_asks;  // the robot is judged without them
  return robot_bounds(analyse(make_timing_model(robot, forest, schedule, instrumented), request, nobody_asks), forest,
                      schedule);
}

}  // namespace finemote::gen::timing
