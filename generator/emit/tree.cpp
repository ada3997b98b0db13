#include "generator/emit/tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/emit/device_definition.hpp"
#include "generator/schedule/period.hpp"

namespace finemote::gen {
namespace {

/// Devices of the tree in one bucket, in schedule order.
std::vector<DeviceId> members(const Plan& plan, const Tree& tree, std::size_t bucket) {
  std::vector<DeviceId> result;
  for (DeviceId device : tree.devices) {
    if (plan.schedule.bucket_of[device] == bucket) result.push_back(device);
  }
  return result;
}

std::string stage_line(const Plan& plan, DeviceId device, const char* stage) {
  const bool is_handle = std::string_view(stage) == "handle";
  const std::size_t number = 2 * plan.forest.rank[device].value() + (is_handle ? 1 : 0);
  return fmt::format("{{ Stage stage{{{}}}; {}.{}(); }}", number, plan.robot.devices[device].name.cpp, stage);
}

std::string with_comment(const std::string& line, const std::string& comment) {
  constexpr std::size_t kColumn = 60;
  return fmt::format("{:<{}}  // {}", line, kColumn, comment);
}

std::string other_end(const Plan& plan, DeviceId device) {
  const Device& d = plan.robot.devices[device];
  return fmt::format("{} ({})", d.name.text, period_text(d.period_ns));
}

/// `ports::imu_to_rov = ports::imu_to_rov_latch.snapshot();` and its kin: the consumer's side of a crossing.
std::string fetch_line(const Plan& plan, const Crossing& crossing) {
  const std::string ports = ports_prefix(plan, crossing.consumer, crossing.home);
  const std::string comment = "from " + other_end(plan, crossing.producer);
  const std::string source = crossing.kind == Crossing::Kind::copy
                                 ? device_reference(plan, crossing.consumer, crossing.producer) + "." + crossing.member
                                 : fmt::format("{}{}_latch.snapshot()", ports, crossing.name);
  const std::string target = crossing.direction == Crossing::Direction::state
                                 ? ports + crossing.name
                                 : plan.robot.devices[crossing.consumer].name.cpp + "." + crossing.member;
  return with_comment(fmt::format("{} = {};", target, source), comment);
}

/// The producer's side; nothing for a plain copy.
std::string publish_line(const Plan& plan, const Crossing& crossing) {
  const std::string ports = ports_prefix(plan, crossing.producer, crossing.home);
  const std::string value = crossing.direction == Crossing::Direction::state
                                ? plan.robot.devices[crossing.producer].name.cpp + "." + crossing.member
                                : ports + crossing.name;
  return with_comment(fmt::format("{}{}_latch.publish({});", ports, crossing.name, value),
                      "to " + other_end(plan, crossing.consumer));
}

std::vector<std::string> sequence(const Plan& plan, const std::vector<DeviceId>& devices, const char* stage,
                                  Crossing::Direction direction) {
  std::vector<std::string> lines;
  for (DeviceId device : devices) {
    for (const Crossing& crossing : plan.schedule.crossings) {
      if (crossing.direction == direction && crossing.consumer == device) lines.push_back(fetch_line(plan, crossing));
    }
    lines.push_back(with_comment(stage_line(plan, device, stage), device_comment(plan, device)));
    for (const Crossing& crossing : plan.schedule.crossings) {
      const bool moved = crossing.direction == direction && crossing.kind != Crossing::Kind::copy;
      if (moved && crossing.producer == device) lines.push_back(publish_line(plan, crossing));
    }
  }
  return lines;
}

Data sequences(const Plan& plan, const Tree& tree) {
  Data list(Data::type::list);
  for (std::size_t bucket : buckets_of(plan, tree)) {
    std::vector<DeviceId> devices = members(plan, tree, bucket);
    Data entry;
    entry.set("period", plan.schedule.buckets[bucket].label);
    entry.set("updates", text_list(sequence(plan, devices, "update", Crossing::Direction::state)));
    std::reverse(devices.begin(), devices.end());
    entry.set("handles", text_list(sequence(plan, devices, "handle", Crossing::Direction::command)));
    list.push_back(entry);
  }
  return list;
}

/// What must be defined before `device`: its children, and devices of its own tree that its ports refer to directly.
std::vector<DeviceId> made_from(const Plan& plan, DeviceId device) {
  std::vector<DeviceId> sources = plan.robot.devices[device].children;
  for (const RoleBinding& role : plan.schedule.roles[device]) {
    for (const Binding& binding : role.bindings) {
      if (binding.is_read && !binding.state_crossing) sources.push_back(binding.device);
    }
  }
  return sources;
}

/// Leaf to root, and a device that another one of the tree reads before its reader: schedule order but for those that
/// read what runs after them. Data never go in circles: the model has seen to that. Iterative: depth is the input's.
std::vector<DeviceId> definition_order(const Plan& plan, const Tree& tree) {
  struct Visit {
    DeviceId device;
    std::vector<DeviceId> sources;
    std::size_t next = 0;
  };
  std::vector<DeviceId> order;
  std::set<DeviceId> seen;
  std::vector<Visit> way;
  const auto enter = [&](DeviceId device) {
    if (seen.insert(device).second) way.push_back({device, made_from(plan, device)});
  };
  for (const DeviceId start : tree.devices) {
    enter(start);
    while (!way.empty()) {
      Visit& visit = way.back();
      if (visit.next < visit.sources.size()) {
        enter(visit.sources[visit.next++]);
      } else {
        order.push_back(visit.device);
        way.pop_back();
      }
    }
  }
  return order;
}

std::string own_header(const Tree& tree) { return "\"trees/" + tree.space + ".hpp\""; }

/// Trees whose objects or latches the sequences of `tree` touch.
std::vector<std::string> touched_headers(const Plan& plan, const Tree& tree) {
  std::vector<std::string> headers{"<finemote/stage.hpp>", own_header(tree)};
  const auto inside = [&](DeviceId device) { return plan.forest.trees[plan.forest.tree_of[device]].root == tree.root; };
  for (const Crossing& crossing : plan.schedule.crossings) {
    if (inside(crossing.producer)) headers.push_back(own_header(plan.forest.trees[plan.forest.tree_of[crossing.home]]));
    const bool copied = crossing.kind == Crossing::Kind::copy && inside(crossing.consumer);
    if (copied) headers.push_back(own_header(plan.forest.trees[plan.forest.tree_of[crossing.producer]]));
  }
  return headers;
}

std::vector<std::string> object_headers(const Plan& plan, const Tree& tree, const std::vector<Constant>& constants) {
  std::vector<std::string> headers{"<finemote/constinit.hpp>", "<finemote/contract.hpp>", "<finemote/interfaces.hpp>",
                                   "\"buses.hpp\""};
  const auto include = [&](const DeviceType& type) {
    headers.push_back("<" + type.include + ">");  // never the tree's own file, whatever the root is called
  };
  for (DeviceId device : tree.devices) {
    const DeviceType& type = *plan.robot.devices[device].type;
    include(type);
    if (!type.builtin && !type.params.empty()) headers.emplace_back("<finemote/config.hpp>");
    if (!type.constant_init) headers.emplace_back("<finemote/order.hpp>");
    for (const Read& read : plan.robot.devices[device].reads) include(*plan.robot.devices[read.device].type);
    for (const Constant& constant : constants) {
      if (constant.device == device && !constant.in_tree && !constant.text.empty())
        headers.emplace_back("\"constants.hpp\"");
    }
  }
  for (const Crossing& crossing : plan.schedule.crossings) {
    const bool here = plan.forest.trees[plan.forest.tree_of[crossing.home]].root == tree.root;
    if (!here) continue;
    headers.emplace_back(crossing.kind == Crossing::Kind::copy ? "<finemote/crossing.hpp>" : "<finemote/latch.hpp>");
  }
  return headers;
}

}  // namespace

std::vector<std::size_t> buckets_of(const Plan& plan, const Tree& tree) {
  std::set<std::size_t> buckets;
  for (DeviceId device : tree.devices) buckets.insert(plan.schedule.bucket_of[device]);
  return {buckets.begin(), buckets.end()};
}

Data tree_header(const Plan& plan, const Tree& tree, const std::vector<Constant>& constants,
                 const ProvenBounds& bounds) {
  Data data = common_data(plan);
  data.set("root", plan.robot.devices[tree.root].name.text);
  data.set("space", tree.space);
  data.set("includes", include_list(object_headers(plan, tree, constants)));
  Data devices(Data::type::list);
  for (DeviceId device : definition_order(plan, tree)) {
    std::vector<std::string> lines = port_lines(plan, device);
    for (const Constant& constant : constants) {
      if (constant.device == device && constant.in_tree) lines.push_back(constant.text);
    }
    const Device& d = plan.robot.devices[device];
    Data entry;
    entry.set("name", d.name.text);
    entry.set("has_ports", !lines.empty());
    entry.set("port_lines", text_list(lines));
    entry.set("comment",
              fmt::format("{}: {}, every {}", d.name.text, device_comment(plan, device), period_text(d.period_ns)));
    entry.set("bound", bound_comment(plan, bounds.plain, device));
    entry.set("definition", device_definition(plan, device, constants));
    devices.push_back(entry);
  }
  data.set("devices", devices);
  data.set("sequences", sequences(plan, tree));
  return data;
}

Data tree_source(const Plan& plan, const Tree& tree) {
  Data data = common_data(plan);
  data.set("root", plan.robot.devices[tree.root].name.text);
  data.set("space", tree.space);
  data.set("includes", include_list(touched_headers(plan, tree)));
  data.set("sequences", sequences(plan, tree));
  return data;
}

}  // namespace finemote::gen
