// finemote tree: the device trees as the user nested them, and the order every bucket runs them in.
#include <fmt/format.h>

#include <algorithm>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/model/device_frames.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

struct Row {
  std::string name;       ///< with the lines of the tree before it
  std::size_t width = 0;  ///< of `name` in columns, not bytes
  DeviceId device;
};

/// Rows of a tree, root first, children in document order. Iterative, like the forest.
std::vector<Row> rows_of(const Robot& robot, DeviceId root) {
  struct Visit {
    DeviceId device;
    std::string lead, child_lead;
    std::size_t depth;
  };
  std::vector<Row> rows;
  std::vector<Visit> stack{{root, "", "", 0}};
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const Device& device = robot.devices[visit.device];
    rows.push_back({visit.lead + device.name.text, 3 * visit.depth + device.name.text.size(), visit.device});
    for (std::size_t i = device.children.size(); i-- > 0;) {
      const bool last = i + 1 == device.children.size();
      stack.push_back({device.children[i], visit.child_lead + (last ? "└─ " : "├─ "),
                       visit.child_lead + (last ? "   " : "│  "), visit.depth + 1});
    }
  }
  return rows;
}

/// The link whose frame the constants computed for a device are in, or the data it delivers; empty where neither is.
std::string link_of(const Robot& robot, DeviceId index) {
  const Device& device = robot.devices[index];
  for (const GeometrySpec& geometry : device.type->geometry) {
    if (geometry.kind == "mount" && !device.link.empty()) return mount_link(robot, index);
    if (!role_joints(robot, device, geometry).empty()) return reference_link(robot, device);
  }
  return {};
}

std::string comment_of(const Plan& plan, DeviceId index) {
  const std::string link = link_of(plan.robot, index);
  return device_comment(plan, index) + (link.empty() ? "" : fmt::format(", geometry about link '{}'", link));
}

std::string trees_text(const PlannedRobot& planned) {
  const Robot& robot = planned.robot;
  std::string text =
      fmt::format("{} on {}, tick {}\n", robot.name.text, robot.board->name, units::spaced_duration(robot.tick));
  for (const Tree& tree : planned.forest.trees) {
    const std::vector<Row> rows = rows_of(robot, tree.root);
    std::size_t widest = 0;
    for (const Row& row : rows) widest = std::max(widest, row.width);
    text += "\n";
    for (const Row& row : rows) {
      text +=
          fmt::format("{}{}  {:>8}  {}\n", row.name, std::string(widest - row.width, ' '),
                      units::spaced_duration(robot.devices[row.device].period), comment_of(planned.plan(), row.device));
    }
  }
  return text;
}

std::string order_text(const PlannedRobot& planned) {
  std::string text;
  for (const Bucket& bucket : planned.schedule.buckets) {
    text += fmt::format("\nevery {}: priority {}, interrupt line {}\n", units::spaced_duration(bucket.period),
                        bucket.priority, bucket.line);
    text += "  update";
    for (const DeviceId device : bucket.devices) text += " " + planned.robot.devices[device].name.text;
    text += "\n  handle";
    for (auto device = bucket.devices.rbegin(); device != bucket.devices.rend(); ++device)
      text += " " + planned.robot.devices[*device].name.text;
    text += "\n";
  }
  return text;
}

Json names(const Robot& robot, const std::vector<DeviceId>& devices) {
  Json list = Json::array();
  for (DeviceId device : devices) list.push_back(robot.devices[device].name.text);
  return list;
}

Json document(const PlannedRobot& planned) {
  const Robot& robot = planned.robot;
  Json trees = Json::array();
  for (const Tree& tree : planned.forest.trees) {
    Json devices = Json::array();
    for (const DeviceId index : tree.devices) {
      const Device& device = robot.devices[index];
      const std::string link = link_of(robot, index);
      devices.push_back(
          {{"name", device.name.text},
           {"parent", device.parent ? Json(robot.devices[*device.parent].name.text) : Json(nullptr)},
           {"type", device.type->name},
           {"role", device.role ? Json(robot.devices[*device.parent].type->roles[*device.role].name) : Json(nullptr)},
           {"period_ns", device.period.ns()},
           {"geometry_link", link.empty() ? Json(nullptr) : Json(link)},
           {"bus", device.segment ? Json(robot.segments[*device.segment].name.text) : Json(nullptr)}});
    }
    trees.push_back({{"root", robot.devices[tree.root].name.text}, {"devices", devices}});
  }
  Json buckets = Json::array();
  for (const Bucket& bucket : planned.schedule.buckets) {
    std::vector<DeviceId> handles(bucket.devices.rbegin(), bucket.devices.rend());
    buckets.push_back({{"period_ns", bucket.period.ns()},
                       {"priority", bucket.priority},
                       {"line", bucket.line},
                       {"update", names(robot, bucket.devices)},
                       {"handle", names(robot, handles)}});
  }
  return Json{{"schema", "finemote.tree/1"}, {"robot", robot.name.text}, {"board", robot.board->name},
              {"tick_ns", robot.tick.ns()},  {"trees", trees},           {"buckets", buckets}};
}

}  // namespace

Answer run_tree(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  const auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  return {kExitYes, trees_text(*planned) + order_text(*planned), document(*planned)};
}

}  // namespace finemote::gen
