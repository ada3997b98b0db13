#include "generator/emit/tree.hpp"

#include <algorithm>
#include <set>

#include "generator/emit/device_fields.hpp"
#include "generator/emit/file_names.hpp"
#include "generator/emit/scope.hpp"
#include "generator/forest/stage.hpp"
#include "generator/units/units.hpp"

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

/// Sets how the comment of a crossing calls its other end.
void set_other_end(const Plan& plan, DeviceId device, Data& data) {
  const Device& d = plan.robot.devices[device];
  data.set("other", d.name.text);
  data.set("other_period", units::spaced_duration(d.period));
}

std::string member_of(const Plan& plan, DeviceId device, const std::string& member) {
  return plan.robot.devices[device].name.cpp + "." + member;
}

/// The consumer's side of a crossing.
Data fetch(const Plan& plan, const Scope& scope, const Crossing& crossing) {
  const std::string port = scope.port(crossing.home, crossing.name);
  const bool is_latched = crossing.kind != Crossing::Kind::copy;
  const bool is_state = crossing.direction == Crossing::Direction::state;
  Data data;
  data.set("target", is_state ? port : member_of(plan, crossing.consumer, crossing.member));
  data.set("source", is_latched ? port : scope.device(crossing.producer) + "." + crossing.member);
  data.set("is_latched", is_latched);
  set_other_end(plan, crossing.producer, data);
  return data;
}

/// The producer's side; a plain copy has none.
Data publish(const Plan& plan, const Scope& scope, const Crossing& crossing) {
  const std::string port = scope.port(crossing.home, crossing.name);
  const bool is_state = crossing.direction == Crossing::Direction::state;
  Data data;
  data.set("port", port);
  data.set("value", is_state ? member_of(plan, crossing.producer, crossing.member) : port);
  set_other_end(plan, crossing.consumer, data);
  return data;
}

Data stage(const Plan& plan, const Scope& scope, DeviceId device, Crossing::Direction direction) {
  const bool is_handle = direction == Crossing::Direction::command;
  Data data, fetches(Data::type::list), publishes(Data::type::list);
  for (const Crossing& crossing : plan.schedule.crossings) {
    if (crossing.direction != direction) continue;
    if (crossing.consumer == device) fetches.push_back(fetch(plan, scope, crossing));
    if (crossing.producer == device && crossing.kind != Crossing::Kind::copy)
      publishes.push_back(publish(plan, scope, crossing));
  }
  data.set("number", std::to_string(Stage{plan.forest.rank[device], is_handle}.number()));
  data.set("device", plan.robot.devices[device].name.cpp);
  data.set("is_update", !is_handle);
  data.set("call", stage_name(is_handle));
  data.set("what", device_comment(plan, device));
  data.set("fetches", fetches);
  data.set("publishes", publishes);
  return data;
}

Data stages(const Plan& plan, const Scope& scope, const std::vector<DeviceId>& devices, Crossing::Direction direction) {
  DataList list;
  list.reserve(devices.size());
  for (DeviceId device : devices) list.push_back(stage(plan, scope, device, direction));
  return list;
}

Data sequences(const Plan& plan, const Tree& tree) {
  const Scope scope(plan, tree.root);
  const std::vector<std::size_t> buckets = buckets_of(plan, tree);
  DataList list;
  list.reserve(buckets.size());
  for (std::size_t bucket : buckets) {
    std::vector<DeviceId> devices = members(plan, tree, bucket);
    Data entry;
    entry.set("period", plan.schedule.buckets[bucket].label);
    entry.set("updates", stages(plan, scope, devices, Crossing::Direction::state));
    std::reverse(devices.begin(), devices.end());
    entry.set("handles", stages(plan, scope, devices, Crossing::Direction::command));
    list.push_back(std::move(entry));
  }
  return list;
}

/// The periods of the tree, for the declarations of its sequences.
Data period_list(const Plan& plan, const Tree& tree) {
  Data list(Data::type::list);
  for (std::size_t bucket : buckets_of(plan, tree)) list.push_back(Data("period", plan.schedule.buckets[bucket].label));
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

std::string own_header(const Tree& tree) { return "\"" + tree_header_name(tree) + "\""; }

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
      if (constant.device == device && !constant.in_tree && constant.exists())
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
  const Scope scope(plan, tree.root);
  DataList devices;
  devices.reserve(tree.devices.size());
  for (DeviceId device : definition_order(plan, tree)) {
    Data& entry = devices.emplace_back();
    entry.set("name", plan.robot.devices[device].name.text);
    entry.set("what", device_comment(plan, device));
    entry.set("period", units::spaced_duration(plan.robot.devices[device].period));
    set_device_bound(plan, bounds.plain, device, entry);
    set_ports(plan, scope, device, constants, entry);
    set_device(plan, scope, device, constants, entry);
  }
  data.set("devices", devices);
  data.set("sequences", period_list(plan, tree));
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
