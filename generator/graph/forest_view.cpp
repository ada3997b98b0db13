#include "generator/graph/forest_view.hpp"

#include <fmt/format.h>

#include "generator/bus/bus_type.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

struct Visit {
  DeviceId device;
  std::size_t depth;
  std::optional<std::size_t> parent;
};

std::string place_of(const Robot& robot, const Device& device) {
  if (!device.segment) return {};
  std::string text = robot.segments[*device.segment].name.text;
  if (device.address) text += fmt::format(" {:#04x}", *device.address);
  if (device.channel) text += fmt::format(" channel {}", *device.channel);
  if (device.id) text += fmt::format(" id {}", *device.id);
  return text;
}

ForestRow row_of(const Robot& robot, const Forest& forest, const Schedule& schedule, const Visit& visit) {
  const Device& device = robot.devices[visit.device];
  ForestRow row{visit.device,
                forest.rank[visit.device],
                visit.depth,
                visit.parent,
                device.name.text,
                device.type->name,
                units::spaced_duration(device.period),
                schedule.bucket_of[visit.device],
                place_of(robot, device),
                std::nullopt,
                {}};
  if (device.segment) row.bus = robot.segments[*device.segment].bus.value();
  return row;
}

/// A tree from its root down. Iterative, like the forest.
void add_tree(const Robot& robot, const Forest& forest, const Schedule& schedule, DeviceId root,
              std::vector<ForestRow>& rows) {
  std::vector<Visit> stack{{root, 0, std::nullopt}};
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const std::vector<DeviceId>& children = robot.devices[visit.device].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      stack.push_back({*child, visit.depth + 1, rows.size()});
    rows.push_back(row_of(robot, forest, schedule, visit));
  }
}

void add_reads(const Robot& robot, ForestView& view) {
  Table<DeviceId, std::size_t> row_of_device(robot.devices.size());
  for (std::size_t i = 0; i < view.rows.size(); ++i) row_of_device[view.rows[i].device] = i;
  for (ForestRow& row : view.rows) {
    for (const Read& read : robot.devices[row.device].reads) row.reads.push_back(row_of_device[read.device]);
  }
}

BusRow bus_row(const Robot& robot, BusId id) {
  const Bus& bus = robot.buses[id];
  BusRow row{bus.name.text, std::string(bus_type(bus.kind).name), {}};
  if (!bus.port.empty()) row.what += " on " + bus.port;
  if (bus.rate > 0 && bus_type(bus.kind).rate.form != nullptr) row.what += ", " + rate_text(bus.kind, bus.rate);
  for (const Expander& expander : robot.expanders) {
    const Segment& segment = robot.segments[expander.segment];
    if (segment.bus == id)
      row.behind.push_back(fmt::format("{}: {} on {}", expander.name.text, expander.type->name, segment.name.text));
  }
  return row;
}

}  // namespace

ForestView view_of(const Robot& robot, const Forest& forest, const Schedule& schedule) {
  ForestView view{robot.name.text, robot.board->name, units::spaced_duration(robot.tick), {}, {}};
  for (const Tree& tree : forest.trees) add_tree(robot, forest, schedule, tree.root, view.rows);
  add_reads(robot, view);
  for (const BusId bus : robot.buses.ids()) view.buses.push_back(bus_row(robot, bus));
  return view;
}

}  // namespace finemote::gen
