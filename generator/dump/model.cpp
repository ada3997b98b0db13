#include "generator/bus/bus_kind.hpp"
#include "generator/dump/dump.hpp"
#include "generator/dump/names.hpp"

namespace finemote::gen {
namespace {

Json params_json(const std::vector<Param>& params) {
  Json list = Json::object();
  for (const Param& param : params)
    list[param.spec->name] = std::visit([](const auto& value) { return Json(value); }, param.value);
  return list;
}

Json bus_json(const Bus& bus) {
  return {{"name", bus.name.text},
          {"type", bus_kind_name(bus.kind)},
          {"port", text_or_null(bus.port)},
          {"rate", bus.rate},
          {"isr_wcet_ns", value_or_null(bus.isr_wcet)},
          {"min_frame_bits", value_or_null(bus.min_frame_bits)},
          {"params", params_json(bus.params)}};
}

Json expander_json(const Robot& robot, const Expander& expander) {
  Json channels = Json::array();
  for (const Expander::Channel& channel : expander.channels)
    channels.push_back({{"index", channel.index}, {"name", channel.name.text}});
  return {{"name", expander.name.text},  {"model", expander.type->name}, {"bus", segment_name(robot, expander.segment)},
          {"address", expander.address}, {"channels", channels},         {"params", params_json(expander.params)}};
}

Json uses_json(const Robot& robot, const Device& device) {
  Json list = Json::array();
  for (const Use& use : device.uses) {
    list.push_back({{"role", use.spec->role},
                    {"bus", use.segment ? segment_name(robot, *use.segment) : Json(nullptr)},
                    {"pin", text_or_null(use.pin)},
                    {"channel", value_or_null(use.channel)}});
  }
  return list;
}

Json reads_json(const Robot& robot, const Device& device) {
  Json list = Json::array();
  for (const Read& read : device.reads)
    list.push_back({{"device", device_name(robot, read.device)}, {"role", device.type->roles[read.role].name}});
  return list;
}

Json device_json(const Robot& robot, const Device& device) {
  return {{"name", device.name.text},
          {"cpp_name", device.name.cpp},
          {"type", device.type->name},
          {"parent", device.parent ? device_name(robot, *device.parent) : Json(nullptr)},
          {"role", device.role ? Json(robot.devices[*device.parent].type->roles[*device.role].name) : Json(nullptr)},
          {"children", device_names(robot, device.children)},
          {"reads", reads_json(robot, device)},
          {"period_ns", device.period.ns()},
          {"bus", device.segment ? segment_name(robot, *device.segment) : Json(nullptr)},
          {"address", value_or_null(device.address)},
          {"channel", value_or_null(device.channel)},
          {"id", value_or_null(device.id)},
          {"link", text_or_null(device.link)},
          {"joint", text_or_null(device.joint)},
          {"params", params_json(device.params)},
          {"uses", uses_json(robot, device)},
          {"wcet",
           {{"update_ns", device.wcet.update.ns()},
            {"handle_ns", device.wcet.handle.ns()},
            {"source", to_string(device.wcet.source)}}}};
}

Json pose_json(const Pose& pose) { return {{"xyz", pose.xyz}, {"rpy", pose.rpy}}; }

Json link_json(const Link& link) {
  Json out{{"name", link.name}, {"inertial", nullptr}};
  if (!link.inertial) return out;
  out["inertial"] = {
      {"origin", pose_json(link.inertial->origin)}, {"mass", link.inertial->mass}, {"inertia", link.inertial->inertia}};
  return out;
}

Json joint_json(const Joint& joint) {
  return {{"name", joint.name},
          {"type", joint.type},
          {"parent", joint.parent_link},
          {"child", joint.child_link},
          {"origin", pose_json(joint.origin)},
          {"axis", joint.axis},
          {"lower", value_or_null(joint.lower)},
          {"upper", value_or_null(joint.upper)},
          {"effort", value_or_null(joint.effort)},
          {"velocity", value_or_null(joint.velocity)},
          {"mimic", text_or_null(joint.mimic)}};
}

Json requirement_json(const Robot& robot, const Requirement& requirement) {
  return {{"text", requirement.text},
          {"from", device_names(robot, requirement.from)},
          {"to", device_names(robot, requirement.to)},
          {"max", requirement.max_text}};
}

}  // namespace

Json dump_model(const Robot& robot) {
  Json out{{"stage", "model"},
           {"robot", robot.name.text},
           {"source", robot.source},
           {"board", robot.board->name},
           {"board_params", params_json(robot.board_params)},
           {"tick_ns", robot.tick.ns()}};
  for (const char* list :
       {"buses", "expanders", "segments", "devices", "requirements", "links", "joints", "ros_joints"})
    out[list] = Json::array();
  for (const Bus& bus : robot.buses) out["buses"].push_back(bus_json(bus));
  for (const Expander& expander : robot.expanders) out["expanders"].push_back(expander_json(robot, expander));
  for (const Segment& segment : robot.segments)
    out["segments"].push_back({{"name", segment.name.text}, {"bus", robot.buses[segment.bus].name.text}});
  for (const Device& device : robot.devices) out["devices"].push_back(device_json(robot, device));
  for (const Requirement& requirement : robot.requirements)
    out["requirements"].push_back(requirement_json(robot, requirement));
  for (const Link& link : robot.links) out["links"].push_back(link_json(link));
  for (const Joint& joint : robot.joints) out["joints"].push_back(joint_json(joint));
  for (const RosJoint& joint : robot.ros_joints)
    out["ros_joints"].push_back({{"name", joint.name}, {"commands", joint.commands}});
  return out;
}

}  // namespace finemote::gen
