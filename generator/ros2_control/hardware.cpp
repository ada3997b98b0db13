#include "generator/ros2_control/hardware.hpp"

#include <algorithm>
#include <charconv>

namespace finemote::gen::ros2_control {
namespace {

std::string attribute(const xml::Node& node, std::string_view name) {
  const xml::Attribute* found = node.attribute(name);
  return found == nullptr ? std::string() : found->value;
}

std::string text_of(const xml::Node& node) {
  std::string text;
  for (const xml::Node& child : node.children) {
    if (child.kind == xml::Node::Kind::text || child.kind == xml::Node::Kind::cdata) text += child.text;
  }
  const auto begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

/// `std::from_chars` reads the same whatever the locale.
std::optional<double> positive_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = error == std::errc() && end == text.data() + text.size();
  return is_whole && value > 0 ? std::optional(value) : std::nullopt;
}

std::optional<Component::Kind> kind_of(const xml::Node& node) {
  if (node.is_element("joint")) return Component::Kind::joint;
  if (node.is_element("sensor")) return Component::Kind::sensor;
  if (node.is_element("gpio")) return Component::Kind::gpio;
  if (node.is_element("transmission")) return Component::Kind::transmission;
  return std::nullopt;
}

/// An interface without a name is none.
void add_interface(const xml::Node& node, std::vector<std::string>& names) {
  if (std::string name = attribute(node, "name"); !name.empty()) names.push_back(std::move(name));
}

Component component_of(const xml::Node& node, Component::Kind kind) {
  Component part{kind, attribute(node, "name"), {}, {}, attribute(node, "mimic") == "true", {}, {}, node.at};
  for (const xml::Node& child : node.children) {
    if (child.is_element("command_interface")) add_interface(child, part.commands);
    if (child.is_element("state_interface")) add_interface(child, part.states);
    if (child.is_element("param") && attribute(child, "name") == "mimic") part.is_mimic = true;
  }
  return part;
}

/// The link that the param `frame_id` names, as drivers of sensors take it.
std::string link_of_sensor(const xml::Node& robot, const xml::Node& sensor) {
  for (const xml::Node& param : sensor.children) {
    if (!param.is_element("param") || attribute(param, "name") != "frame_id") continue;
    const std::string frame = text_of(param);
    const bool is_link = std::any_of(robot.children.begin(), robot.children.end(), [&](const xml::Node& node) {
      return node.is_element("link") && attribute(node, "name") == frame;
    });
    if (is_link) return frame;
  }
  return {};
}

/// What the robot's own element of the joint says: how it moves, and whether by itself.
void look_up_joint(const xml::Node& robot, Component& part) {
  const auto joint = std::find_if(robot.children.begin(), robot.children.end(), [&](const xml::Node& node) {
    return node.is_element("joint") && attribute(node, "name") == part.name;
  });
  if (joint == robot.children.end()) return;
  part.type = attribute(*joint, "type");
  part.is_mimic |= std::any_of(joint->children.begin(), joint->children.end(),
                               [](const xml::Node& child) { return child.is_element("mimic"); });
}

}  // namespace

std::vector<Hardware> read_hardware(const xml::Node& robot) {
  std::vector<Hardware> all;
  for (const xml::Node& node : robot.children) {
    if (!node.is_element("ros2_control")) continue;
    Hardware hardware{attribute(node, "name"), {}, positive_number(attribute(node, "rw_rate")), {}};
    for (const xml::Node& child : node.children) {
      if (const auto kind = kind_of(child)) {
        Component part = component_of(child, *kind);
        if (*kind == Component::Kind::joint) look_up_joint(robot, part);
        if (*kind == Component::Kind::sensor) part.link = link_of_sensor(robot, child);
        hardware.parts.push_back(std::move(part));
      }
      for (const xml::Node& inner : child.children) {
        if (child.is_element("hardware") && inner.is_element("plugin")) hardware.plugin = text_of(inner);
      }
    }
    all.push_back(std::move(hardware));
  }
  return all;
}

}  // namespace finemote::gen::ros2_control
