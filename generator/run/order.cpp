#include "generator/run/order.hpp"

#include <fmt/format.h>

#include "generator/forest/stage.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

/// Start or end of a stage, as a job passes it.
struct Edge {
  DeviceId device;
  bool is_handle = false;
  bool is_end = false;

  [[nodiscard]] bool is_of(const Event& event) const {
    return device == event.device && is_handle == event.is_handle && is_end == event.is_end;
  }
};

std::string text_of(const Robot& robot, DeviceId device, bool is_handle, bool is_end) {
  return fmt::format("{} of {}.{}()", is_end ? "end" : "begin", robot.devices[device].name.text, stage_name(is_handle));
}

/// Everything one job of a bucket passes, in order.
std::vector<Edge> edges_of(const Bucket& bucket) {
  std::vector<Edge> edges;
  const auto add = [&](DeviceId device, bool is_handle) {
    edges.push_back({device, is_handle, false});
    edges.push_back({device, is_handle, true});
  };
  for (const DeviceId device : bucket.devices) add(device, false);
  for (auto device = bucket.devices.rbegin(); device != bucket.devices.rend(); ++device) add(*device, true);
  return edges;
}

}  // namespace

OrderVerdict judge_order(const Robot& robot, const Schedule& schedule, const RunRecord& record) {
  std::vector<std::vector<Edge>> plans;
  for (const Bucket& bucket : schedule.buckets) plans.push_back(edges_of(bucket));
  std::vector<std::size_t> next(plans.size(), 0);
  OrderVerdict verdict;
  for (const Event& event : record.events) {
    const std::size_t bucket = schedule.bucket_of[event.device];
    const std::vector<Edge>& plan = plans[bucket];
    const bool begins_anew = record.resets + record.scripted_resets > 0 && plan.front().is_of(event);
    if (begins_anew) next[bucket] = 0;
    const Edge& due = plan[next[bucket]];
    verdict.is_judged = true;
    if (!due.is_of(event)) {
      verdict.mistake =
          fmt::format("{} at {}, where the {} was due", text_of(robot, event.device, event.is_handle, event.is_end),
                      units::format_duration(event.at), text_of(robot, due.device, due.is_handle, due.is_end));
      return verdict;
    }
    next[bucket] = (next[bucket] + 1) % plan.size();
  }
  return verdict;
}

}  // namespace finemote::gen
