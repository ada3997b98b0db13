#include "generator/dump/dump.hpp"
#include "generator/dump/names.hpp"

namespace finemote::gen {
namespace {

Json bucket_json(const Robot& robot, const Bucket& bucket) {
  Json flushes = Json::array();
  for (const auto segment : bucket.flushes) flushes.push_back(segment_name(robot, segment));
  return {{"period_ns", bucket.period.ns()},
          {"label", bucket.label},
          {"priority", bucket.priority},
          {"line", bucket.line},
          {"devices", device_names(robot, bucket.devices)},
          {"flushes", flushes}};
}

const char* kind_name(Crossing::Kind kind) {
  switch (kind) {
    case Crossing::Kind::to_slow:
      return "to slow";
    case Crossing::Kind::to_fast:
      return "to fast";
    case Crossing::Kind::copy:
      return "copy";
  }
  return "";
}

Json crossing_json(const Robot& robot, const Crossing& crossing) {
  return {{"name", crossing.name},
          {"carries", crossing.direction == Crossing::Direction::state ? "state" : "command"},
          {"kind", kind_name(crossing.kind)},
          {"producer", device_name(robot, crossing.producer)},
          {"consumer", device_name(robot, crossing.consumer)},
          {"home", device_name(robot, crossing.home)},
          {"type", crossing.type}};
}

Json binding_json(const Robot& robot, const Schedule& schedule, const Binding& binding) {
  const auto crossing = [&](const std::optional<std::size_t>& index) {
    return index ? Json(schedule.crossings[*index].name) : Json(nullptr);
  };
  return {{"device", device_name(robot, binding.device)},
          {"read", binding.is_read},
          {"state_crossing", crossing(binding.state_crossing)},
          {"command_crossing", crossing(binding.command_crossing)},
          {"sink", text_or_null(binding.sink_name)}};
}

Json roles_json(const Robot& robot, const Schedule& schedule) {
  Json list = Json::array();
  for (const DeviceId device : robot.devices.ids()) {
    for (std::size_t role = 0; role < schedule.roles[device].size(); ++role) {
      const RoleBinding& binding = schedule.roles[device][role];
      Json bindings = Json::array();
      for (const Binding& one : binding.bindings) bindings.push_back(binding_json(robot, schedule, one));
      list.push_back({{"device", device_name(robot, device)},
                      {"role", robot.devices[device].type->roles[role].name},
                      {"interface", binding.interface},
                      {"array", text_or_null(binding.array)},
                      {"bindings", bindings}});
    }
  }
  return list;
}

Json slot_json(const Robot& robot, const Slot& slot) {
  return {{"name", slot.name},
          {"bus", segment_name(robot, slot.segment)},
          {"device", slot.device ? device_name(robot, *slot.device) : Json(nullptr)},
          {"expander", slot.expander ? Json(robot.expanders[*slot.expander].name.text) : Json(nullptr)},
          {"address", slot.address},
          {"priority", slot.priority}};
}

}  // namespace

Json dump_schedule(const Robot& robot, const Schedule& schedule) {
  Json out{{"stage", "schedule"},
           {"buckets", Json::array()},
           {"crossings", Json::array()},
           {"roles", roles_json(robot, schedule)},
           {"slots", Json::array()}};
  for (const Bucket& bucket : schedule.buckets) out["buckets"].push_back(bucket_json(robot, bucket));
  for (const Crossing& crossing : schedule.crossings) out["crossings"].push_back(crossing_json(robot, crossing));
  for (const Slot& slot : schedule.slots) out["slots"].push_back(slot_json(robot, slot));
  return out;
}

}  // namespace finemote::gen
