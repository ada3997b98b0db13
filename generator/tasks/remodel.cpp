#include "generator/tasks/remodel.hpp"

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/tasks/robot_buses.hpp"

namespace finemote::gen::timing {
namespace {

/// Those that take over their parent's period.
bool inherits(const gen::Device& device, const gen::Device& parent) {
  return device.period == parent.period && device.period_at == parent.period_at;
}

/// The robot's devices whose period changes when it is written at `devices` of the model.
std::vector<DeviceId> followers(const Robot& robot, const Forest& forest, const std::vector<Rank>& devices) {
  std::vector<DeviceId> list;
  for (const Rank d : devices) list.push_back(forest.order[d]);
  Table<DeviceId, bool> is_listed(robot.devices.size(), false);
  for (const DeviceId d : list) is_listed[d] = true;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const gen::Device& parent = robot.devices[list[i]];
    for (const DeviceId child : parent.children) {
      if (is_listed[child] || !inherits(robot.devices[child], parent)) continue;
      is_listed[child] = true;
      list.push_back(child);
    }
  }
  return list;
}

/// Puts devices that sit on a bus itself, and use it for nothing else, onto a copy of it. False where that cannot be
/// done, or where pins differ from port to port.
bool move_to_new_bus(Robot& robot, const Forest& forest, const Change& change) {
  const BusId from = BusPlaces(robot).buses()[change.bus];
  if (!bus_type(robot.buses[from].kind).is_shared) return false;
  const SegmentId old = Robot::segment_of(from);
  Segment segment = robot.segments[old];
  segment.bus = robot.buses.push_back(robot.buses[from]);
  const SegmentId fresh = robot.segments.push_back(segment);
  for (const Rank d : change.devices) {
    gen::Device& device = robot.devices[forest.order[d]];
    const bool uses_more = std::any_of(device.uses.begin(), device.uses.end(),
                                       [](const gen::Use& use) { return use.segment.has_value(); });
    if (device.segment != old || uses_more) return false;
    device.segment = fresh;
  }
  return true;
}

bool apply(Robot& robot, const Forest& forest, const Change& change) {
  switch (change.kind) {
    case Change::Kind::rate:
      robot.buses[BusPlaces(robot).buses()[change.bus]].rate = change.value;
      return true;
    case Change::Kind::period:
      for (const DeviceId d : followers(robot, forest, change.devices)) robot.devices[d].period = change.period;
      return true;
    case Change::Kind::bus:
      return move_to_new_bus(robot, forest, change);
    case Change::Kind::work:
      return true;  // of the model
  }
  return false;
}

std::optional<Model> remodel(const Robot& robot, const Forest& forest, const RobotTimingOptions& options,
                             const std::vector<Change>& changes) {
  Robot changed = robot;
  for (const Change& change : changes) {
    if (!apply(changed, forest, change)) return std::nullopt;
  }
  Diagnostics mistakes;
  const Schedule schedule = plan_schedule(changed, forest, mistakes);
  if (mistakes.has_errors()) return std::nullopt;
  std::optional<Model> model = make_timing_model(changed, forest, schedule, mistakes, options);
  if (model) change_work(*model, changes);
  return model;
}

}  // namespace

Remodel robot_remodel(const Robot& robot, const Forest& forest, const RobotTimingOptions& options) {
  return [&robot, &forest, options](const std::vector<Change>& changes) {
    return remodel(robot, forest, options, changes);
  };
}

}  // namespace finemote::gen::timing
