#include "generator/cli/diff_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/bus/bus_kind.hpp"
#include "generator/emit/names.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

void add_params(const std::vector<Param>& params, Properties& facts) {
  for (const Param& param : params) {
    facts["param '" + param.spec->name + "'"] =
        std::visit([](const auto& value) { return fmt::format("{}", value); }, param.value);
  }
}

template <typename T>
void add_given(const char* property, const std::optional<T>& value, Properties& facts) {
  if (value) facts[property] = fmt::format("{}", *value);
}

Properties bus_facts(const Bus& bus) {
  Properties facts{{"type", bus_kind_name(bus.kind)}, {"port", bus.port}, {"rate", std::to_string(bus.rate)}};
  if (bus.isr_wcet) facts["isr_wcet [ns]"] = std::to_string(bus.isr_wcet->ns());
  add_given("min_frame [bit]", bus.min_frame_bits, facts);
  add_params(bus.params, facts);
  return facts;
}

Properties expander_facts(const Robot& robot, const Expander& expander) {
  Properties facts{{"model", expander.type->name},
                   {"bus", robot.segments[expander.segment].name.text},
                   {"address", fmt::format("{:#04x}", expander.address)}};
  for (const Expander::Channel& channel : expander.channels)
    facts[fmt::format("channel '{}'", channel.name.text)] = std::to_string(channel.index);
  add_params(expander.params, facts);
  return facts;
}

std::string use_text(const Robot& robot, const Use& use) {
  std::string text = use.segment ? robot.segments[*use.segment].name.text : use.pin;
  if (use.channel) text += fmt::format(" channel {}", *use.channel);
  return text;
}

std::string reads_text(const Robot& robot, const Device& device) {
  std::string text;
  for (const Read& read : device.reads) {
    text += fmt::format("{}{} as {}", text.empty() ? "" : ", ", robot.devices[read.device].name.text,
                        device.type->roles[read.role].name);
  }
  return text;
}

/// The device it runs after: a device that comes or goes changes that of one other, whatever follows.
std::string order_text(const PlannedRobot& planned, DeviceId index) {
  const std::size_t rank = planned.forest.rank[index].value();
  if (rank == 0) return "first";
  return fmt::format("after '{}'", planned.robot.devices[planned.forest.order[Rank(rank - 1)]].name.text);
}

/// What labels call it.
const char* source_word(Wcet::Source source) { return source == Wcet::Source::computed ? "static" : to_string(source); }

Properties device_facts(const PlannedRobot& planned, DeviceId index) {
  const Robot& robot = planned.robot;
  const Device& device = robot.devices[index];
  Properties facts{
      {"type", device.type->name},
      {"parent", device.parent ? robot.devices[*device.parent].name.text : "none"},
      {"period", units::spaced_duration(device.period)},
      {"place", device_comment(planned.plan(), index)},
      {"order", order_text(planned, index)},
      {"wcet", fmt::format("update {} ns, handle {} ns", device.wcet.update.ns(), device.wcet.handle.ns())},
      {"source of the wcet", source_word(device.wcet.source)}};
  if (device.parent && device.role) facts["role"] = robot.devices[*device.parent].type->roles[*device.role].name;
  if (!device.link.empty()) facts["link"] = device.link;
  if (!device.joint.empty()) facts["joint"] = device.joint;
  if (!device.reads.empty()) facts["reads"] = reads_text(robot, device);
  for (const Use& use : device.uses) facts[fmt::format("use '{}'", use.spec->role)] = use_text(robot, use);
  add_params(device.params, facts);
  return facts;
}

void add_pose(const Pose& pose, Properties& facts) {
  facts["origin xyz"] = fmt::format("{}", fmt::join(pose.xyz, " "));
  facts["origin rpy"] = fmt::format("{}", fmt::join(pose.rpy, " "));
}

Properties link_facts(const Link& link) {
  Properties facts;
  if (!link.inertial) return facts;
  facts["mass"] = fmt::format("{}", link.inertial->mass);
  facts["inertia"] = fmt::format("{}", fmt::join(link.inertial->inertia, " "));
  add_pose(link.inertial->origin, facts);
  return facts;
}

Properties joint_facts(const Joint& joint) {
  Properties facts{{"type", joint.type},
                   {"parent", joint.parent_link},
                   {"child", joint.child_link},
                   {"axis", fmt::format("{}", fmt::join(joint.axis, " "))}};
  add_pose(joint.origin, facts);
  add_given("lower", joint.lower, facts);
  add_given("upper", joint.upper, facts);
  add_given("effort", joint.effort, facts);
  add_given("velocity", joint.velocity, facts);
  add_given("damping", joint.damping, facts);
  add_given("friction", joint.friction, facts);
  if (!joint.mimic.empty()) facts["mimic"] = joint.mimic;
  return facts;
}

std::string requirement_name(const Requirement& requirement) {
  switch (requirement.kind) {
    case Requirement::Kind::latency_end_to_end:
      return fmt::format("requirement latency '{}'", requirement.text);
    case Requirement::Kind::latency_decision:
      return fmt::format("requirement latency '{}' of decision", requirement.text);
    case Requirement::Kind::utilization:
      return fmt::format("requirement utilization '{}'", requirement.text);
    case Requirement::Kind::jitter:
      return fmt::format("requirement jitter '{}'", requirement.text);
  }
  return {};
}

/// The same question may be asked twice.
void add_requirement(const Requirement& requirement, Facts& facts) {
  const std::string name = requirement_name(requirement);
  std::string subject = name;
  for (int n = 2; facts.count(subject) != 0; ++n) subject = fmt::format("{} ({})", name, n);
  facts[subject]["max"] = requirement.max_text;
}

}  // namespace

Facts facts_of(const PlannedRobot& planned) {
  const Robot& robot = planned.robot;
  Facts facts;
  facts["robot"] = {
      {"name", robot.name.text}, {"board", robot.board->name}, {"tick", units::spaced_duration(robot.tick)}};
  add_params(robot.board_params, facts["robot"]);
  for (const Bus& bus : robot.buses) facts[fmt::format("bus '{}'", bus.name.text)] = bus_facts(bus);
  for (const Expander& expander : robot.expanders)
    facts[fmt::format("expander '{}'", expander.name.text)] = expander_facts(robot, expander);
  for (const DeviceId device : robot.devices.ids())
    facts[fmt::format("device '{}'", robot.devices[device].name.text)] = device_facts(planned, device);
  for (const Link& link : robot.links) facts[fmt::format("link '{}'", link.name)] = link_facts(link);
  for (const Joint& joint : robot.joints) facts[fmt::format("joint '{}'", joint.name)] = joint_facts(joint);
  for (const Requirement& requirement : robot.requirements) add_requirement(requirement, facts);
  return facts;
}

}  // namespace finemote::gen
