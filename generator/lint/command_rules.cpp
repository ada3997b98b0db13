#include "generator/lint/command_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace finemote::gen {
namespace {

/// What a device with a shipped interface does with a joint, in the words of ros2_control.
struct Drive {
  std::string_view interface;
  std::string_view takes;                       ///< in our words
  std::array<std::string_view, 2> commands;     ///< as which ROS commands it
  std::array<std::string_view, 2> with_parent;  ///< what a parent can make it follow, by the state it reports
};

constexpr Drive kDrives[] = {
    {"Servo", "an angle", {"position"}, {}},
    {"Motor", "a torque", {"effort"}, {"velocity", "position"}},
    {"Thruster", "a share of full drive", {"effort", "velocity"}, {}},
};

constexpr std::string_view kKnown[] = {"position", "velocity", "acceleration", "effort"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

const Drive* drive_of(const Device& device) {
  for (const Drive& drive : kDrives) {
    const auto& all = device.type->provides;
    if (std::any_of(all.begin(), all.end(), [&](const Interface& own) { return own.name == drive.interface; }))
      return &drive;
  }
  return nullptr;
}

const Device* parent_of(const Robot& robot, const Device& device) {
  return device.parent ? &robot.devices[*device.parent] : nullptr;
}

/// Whether the parent knows what its child is, so that it can command it.
bool is_commanded(const Robot& robot, const Device& device) {
  const Device* parent = parent_of(robot, device);
  return parent != nullptr && device.role && parent->type->roles[*device.role].interface != "any";
}

/// One of the joint's commands is the device's; what has another name than those of ROS may be anything.
bool agrees(const Robot& robot, const RosJoint& joint, const Device& device, const Drive& drive) {
  return std::any_of(joint.commands.begin(), joint.commands.end(), [&](const std::string& command) {
    return !contains(kKnown, command) || contains(drive.commands, command) ||
           (contains(drive.with_parent, command) && is_commanded(robot, device));
  });
}

std::string commands_text(const RosJoint& joint) {
  if (joint.commands.empty()) return "takes no command";
  return fmt::format("takes the command{} '{}'", joint.commands.size() > 1 ? "s" : "",
                     fmt::join(joint.commands, "', '"));
}

/// What would agree.
void add_hints(const Robot& robot, const RosJoint& joint, const Device& device, const Drive& drive,
               Diagnostic& finding) {
  const bool needs_parent = std::any_of(joint.commands.begin(), joint.commands.end(), [&](const std::string& command) {
    return contains(drive.with_parent, command);
  });
  if (needs_parent) {
    const Device* parent = parent_of(robot, device);
    finding
        .note(parent == nullptr ? "it has no parent that makes one of the other"
                                : fmt::format("its parent '{}' is of type '{}', which does not make one of the other",
                                              parent->name.text, parent->type->name))
        .hint(fmt::format("give it a parent with a role for a '{}', for example of a type of your own (finemote "
                          "scaffold device)",
                          drive.interface));
  }
  finding.hint(fmt::format("does ROS mean <command_interface name=\"{}\"/>?", drive.commands.front()));
}

}  // namespace

void find_other_commands(const Robot& robot, Findings& findings) {
  for (const RosJoint& joint : robot.ros_joints) {
    for (const Device& device : robot.devices) {
      const Drive* drive = device.joint == joint.name ? drive_of(device) : nullptr;
      if (drive == nullptr || agrees(robot, joint, device, *drive)) continue;
      Diagnostic& finding =
          findings.add(joint.at, fmt::format("joint '{}' {} in <ros2_control>, and device '{}' takes {}", joint.name,
                                             commands_text(joint), device.name.text, drive->takes));
      finding.underline(std::string_view("<joint").size())
          .note(fmt::format("device '{}' of type '{}' drives it", device.name.text, device.type->name), device.at);
      add_hints(robot, joint, device, *drive, finding);
    }
  }
}

}  // namespace finemote::gen
