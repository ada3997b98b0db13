#include "generator/run/parts.hpp"

#include <fmt/format.h>

#include <iterator>

#include "emulator/scenario/grammar.hpp"
#include "generator/bus/bus_type.hpp"
#include "generator/bus/line_format.hpp"
#include "generator/geometry/mechanism.hpp"
#include "generator/model/sample_interval.hpp"
#include "generator/run/emulation.hpp"
#include "generator/run/mechanics.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

const BusType& type_of(const Robot& robot, SegmentId segment) { return bus_type(robot.segments[segment].bus_kind); }

void add_line_format(const Bus& bus, const std::string& text, Json& part) {
  const LineFormat format = line_format(text);
  part["baud"] = bus.rate;
  part["even_parity"] = format.has_even_parity;
  part["stop_bits"] = format.stop_bits;
}

/// Where a part sits: behind a mux channel, at an expander's output, or at a port.
void add_place(const Robot& robot, SegmentId index, Json& part) {
  const Segment& segment = robot.segments[index];
  switch (segment.kind) {
    case Segment::Kind::mux_channel:
      part["mux"] = robot.expanders[*segment.expander].name.text;
      part["channel"] = segment.channel;
      return;
    case Segment::Kind::pwm_expander:
      part["pwm"] = robot.expanders[*segment.expander].name.text;
      return;
    case Segment::Kind::bus:
      part["port"] = robot.buses[segment.bus].port;
  }
}

/// Params that the part's model is told.
void add_params(const Emulation& emulation, const std::vector<Param>& params, Json& part) {
  for (const std::string& name : emulation.params) {
    const Param* param = find_param(params, name);
    if (param != nullptr) std::visit([&](const auto& value) { part[name] = value; }, param->value);
  }
}

Json expander_part(const Robot& robot, const Expander& expander) {
  const Emulation& emulation = expander.type->emulation;
  Json part{{"type", emulation.part}, {"name", expander.name.text}};
  add_place(robot, expander.segment, part);
  part["address"] = expander.address;
  if (emulation.values) part.update(*emulation.values);
  add_params(emulation, expander.params, part);
  return part;
}

/// The identifier of a device's own frames, the first where there are several, and its word in the frame it shares.
void add_identifiers(const Device& device, Json& part) {
  if (!device.id) return;
  part["id"] = *device.id;
  if (!device.type->receives.empty()) part["feedback_id"] = device.type->receives.front().of(*device.id).first;
  if (const auto frame = device.type->shared_frame(*device.id)) {
    part["command_id"] = frame->identifier;
    part["word"] = *device.id - frame->id_min;
  }
}

/// Further hardware by its role: the place of a pulse output, a chip select's number, or a pin.
void add_uses(const Robot& robot, const Device& device, Json& part) {
  for (const Use& use : device.uses) {
    if (use.segment && type_of(robot, *use.segment).channels == BusType::Channels::outputs) {
      Json output = Json::object();
      add_place(robot, *use.segment, output);
      if (use.channel) output["channel"] = *use.channel;
      part[use.spec->role] = output;
    } else if (use.channel) {
      part[use.spec->role] = *use.channel;
    } else if (!use.pin.empty()) {
      part[use.spec->role] = use.pin;
    }
  }
}

void add_bus(const Robot& robot, const Device& device, Json& part) {
  add_place(robot, *device.segment, part);
  const Segment& segment = robot.segments[*device.segment];
  if (type_of(robot, *device.segment).has_line_format) {
    add_line_format(robot.buses[segment.bus], device.type->format, part);
  }
  if (device.address) part["address"] = *device.address;
  if (device.channel) part["channel"] = *device.channel;
  add_identifiers(device, part);
  add_uses(robot, device, part);
}

/// How often it sends, where the robot says so, and what.
void add_stream(const Device& device, const CommandFrame* frame, Json& part) {
  const bool is_set = device.type->acquisition && !device.type->acquisition->interval_param.empty();
  if (is_set) part["period_ns"] = sample_interval(device).value_or(Duration::zero()).ns();
  if (frame == nullptr) return;
  part["layout"] = frame->layout;
  part["values"] = frame->values;
}

/// What the part feels of the body, or does to it.
void add_mechanics(const Robot& robot, const Device& device, const std::string& body, Json& part) {
  const std::string joint = device.type->actuator ? driven_joint(robot, device) : std::string();
  if (const auto axis =
          joint.empty() ? std::nullopt : joint_axis(Mechanism(robot.links, robot.joints), joint, body_link(robot))) {
    part["body"] = body;
    part["xyz"] = {axis->point.x(), axis->point.y(), axis->point.z()};
    part["axis"] = {axis->direction.x(), axis->direction.y(), axis->direction.z()};
    part.update(load_of(robot, joint));
  } else if (device.type->emulation.body.empty() && !body.empty()) {
    part["body"] = body;
    part["way"] = way_to(robot, device.link);
  }
}

/// A serial line that a device uses for people or a computer: a terminal at its other end.
Json terminal_part(const Robot& robot, const Device& device, const Use& use) {
  Json part{{"type", "host_terminal"}, {"name", device.name.text + "." + use.spec->role}};
  add_place(robot, *use.segment, part);
  add_line_format(robot.buses[robot.segments[*use.segment].bus], use.spec->format, part);
  return part;
}

/// The part that turns a child's joint, and where that is; null, with the reason, where nothing does.
Json wheel_of(const Robot& robot, const Device& child, std::string& reason) {
  const auto actuators = actuators_in(robot, child);
  const std::string joint = actuators.size() == 1 ? driven_joint(robot, *actuators[0]) : std::string();
  const auto axis =
      joint.empty() ? std::nullopt : joint_axis(Mechanism(robot.links, robot.joints), joint, body_link(robot));
  if (axis) {
    return Json{{"part", actuators[0]->name.text},
                {"xyz", {axis->point.x(), axis->point.y(), axis->point.z()}},
                {"axis", {axis->direction.x(), axis->direction.y(), axis->direction.z()}}};
  }
  reason = actuators.empty()      ? "has no actuator with a model"
           : actuators.size() > 1 ? "has several actuators"
           : joint.empty()        ? "has no 'joint'"
                                  : fmt::format("turns no axis: its joint is '{}'", joint);
  return {};
}

/// Wheels in a role of a device; what drives none is in `notes`.
Json wheels_of(const Robot& robot, const Device& device, const std::string& role, std::vector<std::string>& notes) {
  Json list = Json::array();
  for (const DeviceId index : device.children) {
    const Device& child = robot.devices[index];
    if (!child.role || device.type->roles[*child.role].name != role) continue;
    std::string reason;
    const Json wheel = wheel_of(robot, child, reason);
    if (wheel.is_null())
      notes.push_back(fmt::format("'{}' {}", child.name.text, reason));
    else
      list.push_back(wheel);
  }
  return list;
}

/// What a device makes of the body: the kind of body, with what it needs to know; null: nothing.
Json body_by(const Robot& robot, const Device& device, std::vector<UndrivenBody>& undriven) {
  const Emulation& emulation = device.type->emulation;
  if (emulation.body.empty()) return {};
  Json part{{"type", emulation.body}};
  if (!emulation.part.empty()) return driven_joint(robot, device).empty() ? Json() : part;
  UndrivenBody finding{device.at, {}, {}};
  part["wheels"] = wheels_of(robot, device, emulation.wheels, finding.notes);
  add_params(emulation, device.params, part);
  if (!finding.notes.empty() || part["wheels"].empty()) {
    finding.message =
        fmt::format("on the emulated board {} wheel{} of '{}' drive{} the robot's body",
                    part["wheels"].empty() ? "no" : "only " + std::to_string(part["wheels"].size()),
                    part["wheels"].size() == 1 ? "" : "s", device.name.text, part["wheels"].size() == 1 ? "s" : "");
    undriven.push_back(finding);
  }
  return part["wheels"].empty() ? Json() : part;
}

/// One body: of the kind the first device asks for that moves it, else standing.
Json body_part(const Robot& robot, std::vector<UndrivenBody>& undriven) {
  const std::string root = body_link(robot);
  if (root.empty()) return {};
  Json part{{"type", "standing_body"}, {"name", root}};
  for (const Device& device : robot.devices) {
    if (device.name.text == root) part["name"] = root + ".body";
    const Json wanted = part["type"] == "standing_body" ? body_by(robot, device, undriven) : Json();
    if (wanted.is_object()) part.update(wanted);
  }
  if (part["type"] != "standing_body") part.update(whole_inertia(robot));
  return part;
}

/// Leaves of the places and mechanics what the part's model has a figure for.
void leave_known(const std::string& type, Json& part) {
  const scenario::Model* model = scenario::find_model(type);
  if (model == nullptr) return;
  for (auto it = part.begin(); it != part.end();) {
    const bool is_known =
        scenario::find_member(model->figures, it.key()) != nullptr || it.key() == "type" || it.key() == "name";
    it = is_known ? std::next(it) : part.erase(it);
  }
}

/// What hangs at driven joints; null: nothing.
Json weights_part(const Robot& robot, const Json& body) {
  Json joints = hanging_joints(robot);
  if (joints.empty()) return {};
  const auto name = body["name"].get<std::string>();
  return Json{{"type", "weights"}, {"name", name + ".weights"}, {"body", name}, {"joints", joints}};
}

/// Of a device that has one on the emulated board.
Json device_part(const Robot& robot, DeviceId id, const std::string& body, const CommandFrames& frames) {
  const Device& device = robot.devices[id];
  const Emulation& emulation = device.type->emulation;
  const auto frame = frames.find(id);
  Json part{{"type", emulation.part}, {"name", device.name.text}};
  add_bus(robot, device, part);
  add_mechanics(robot, device, body, part);
  add_stream(device, frame == frames.end() ? nullptr : &frame->second, part);
  leave_known(part["type"], part);
  if (emulation.values) part.update(*emulation.values);
  add_params(emulation, device.params, part);
  return part;
}

/// A name that no device has.
std::string free_name(const Robot& robot, std::string name) {
  const auto is_taken = [&] {
    return std::any_of(robot.devices.begin(), robot.devices.end(),
                       [&](const Device& device) { return device.name.text == name; });
  };
  while (is_taken()) name += '_';
  return name;
}

/// Of a device without a model: on CAN a node that acknowledges what is sent to it, or the controller would repeat it
/// for ever; null elsewhere.
Json stand_in(const Robot& robot, const Device& device) {
  if (!type_of(robot, *device.segment).is_arbitrated) return {};
  Json part{{"type", "can_listener"}, {"name", free_name(robot, device.name.text + ".node")}};
  add_place(robot, *device.segment, part);
  return part;
}

}  // namespace

EmulatedParts emulated_parts(const Robot& robot, const CommandFrames& frames) {
  EmulatedParts result;
  Json parts = Json::array();
  const Json body = body_part(robot, result.undriven);
  if (!body.is_null()) parts.push_back(body);
  for (const Expander& expander : robot.expanders) {
    if (has_part(robot, expander)) parts.push_back(expander_part(robot, expander));
  }
  for (const DeviceId id : robot.devices.ids()) {
    const Device& device = robot.devices[id];
    if (has_part(robot, device)) {
      parts.push_back(device_part(robot, id, body.is_null() ? "" : body["name"], frames));
    } else if (device.segment) {
      result.silent.push_back(device.name.text);
      if (const Json part = stand_in(robot, device); !part.is_null()) parts.push_back(part);
    }
    for (const Use& use : device.uses) {
      const bool serial = use.segment && type_of(robot, *use.segment).has_line_format;
      if (serial) parts.push_back(terminal_part(robot, device, use));
    }
  }
  const Json weights = body.is_null() ? Json() : weights_part(robot, body);
  if (!weights.is_null()) parts.push_back(weights);
  result.scenario = Json{{"schema", "finemote.scenario/1"}, {"parts", parts}, {"events", Json::array()}};
  return result;
}

}  // namespace finemote::gen
