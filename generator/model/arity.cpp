// How many children and `reads` each role of a device has: FM3055 (too few) and FM3056 (too many).
#include <fmt/format.h>

#include <algorithm>

#include "generator/bus/bus_type.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

/// Types a role takes: shipped ones, and those of the user that the robot has already; not for a role that takes all.
std::vector<const DeviceType*> fitting_types(Reading& reading, const RoleSpec& role) {
  std::vector<const DeviceType*> types;
  if (role.interface == "any") return types;
  std::vector<std::string> names;
  for (const LibraryFile& file : reading.library.device_files) {
    if (file.builtin || reading.library.device_type(file.name) != nullptr) names.push_back(file.name);
  }
  for (const std::string& name : names) {
    const DeviceType* type = find_device_type(reading.library, name, reading.sources, reading.diagnostics);
    if (type != nullptr && satisfies(*type, role)) types.push_back(type);
  }
  return types;
}

/// Writes the child that is missing, at a place that is free.
class MissingChild {
 public:
  MissingChild(Reading& reading, DeviceId parent, std::size_t role)
      : reading_(reading), parent_(reading.robot.devices[parent]), role_(role) {}

  std::string text(const std::vector<const DeviceType*>& types) const {
    const Device* sibling = nullptr;
    for (const DeviceId child : parent_.children) {
      const Device& device = reading_.robot.devices[child];
      if (device.role == role_ && device.type != nullptr) sibling = &device;
    }
    const DeviceType* type = sibling != nullptr ? sibling->type : types.empty() ? nullptr : types.front();
    const std::string name = free_name(sibling);
    return fmt::format("<device name=\"{}\" type=\"{}\" role=\"{}\"{}{}/>", name,
                       type != nullptr ? type->name : "sim_load", parent_.type->roles[role_].name,
                       type != nullptr ? place(*type, sibling) : "", joint(name));
  }

 private:
  /// The sibling's name with the next number that is free: `thruster_8`; without a sibling that of the role.
  std::string free_name(const Device* sibling) const {
    std::string stem = sibling != nullptr ? sibling->name.text : parent_.type->roles[role_].name;
    while (!stem.empty() && stem.back() >= '0' && stem.back() <= '9') stem.pop_back();
    const bool has_mark = !stem.empty() && (stem.back() == '_' || stem.back() == '-');
    const bool was_numbered = sibling != nullptr && stem.size() < sibling->name.text.size();
    if (!has_mark && !was_numbered) stem += '_';
    const auto taken = [&](const std::string& name) {
      return std::any_of(reading_.robot.devices.begin(), reading_.robot.devices.end(),
                         [&](const Device& device) { return device.name.text == name; });
    };
    std::size_t number = 1;
    while (taken(stem + std::to_string(number))) ++number;
    return stem + std::to_string(number);
  }

  /// ` joint="thruster_8_joint"` where the parent computes something from it.
  std::string joint(const std::string& name) const {
    const std::string& role = parent_.type->roles[role_].name;
    const bool is_needed = std::any_of(parent_.type->geometry.begin(), parent_.type->geometry.end(),
                                       [&](const GeometrySpec& geometry) { return geometry.role == role; });
    if (!is_needed) return {};
    const std::vector<std::string> offers = offered_joints(reading_, parent_, role, name, true);
    return fmt::format(" joint=\"{}\"", offers.empty() ? "..." : offers.front());
  }

  /// ` bus="pwm" channel="7"`: on the bus of the sibling where there is room, else on the first with room.
  std::string place(const DeviceType& type, const Device* sibling) const {
    if (type.buses.empty()) return {};
    const auto& segments = reading_.robot.segments;
    std::vector<SegmentId> candidates;
    if (sibling != nullptr && sibling->segment) candidates.push_back(*sibling->segment);
    for (const SegmentId i : segments.ids()) {
      const bool fits = std::find(type.buses.begin(), type.buses.end(), segments[i].bus_kind) != type.buses.end();
      if (fits && !bus_type(segments[i].bus_kind).is_for_one) candidates.push_back(i);
    }
    for (const SegmentId segment : candidates) {
      const auto number = number_on(type, segment);
      if (number) return fmt::format(" bus=\"{}\"{}", segments[segment].name.text, *number);
    }
    return type.bus_required ? " bus=\"...\"" : "";
  }
  /// ` channel="7"`, ` id="2"`; none when nothing is free there.
  [[nodiscard]] std::optional<std::string> number_on(const DeviceType& type, SegmentId segment) const {
    if (type.needs_id) {
      const auto ids = free_ids(reading_, type, segment);
      return ids.empty() ? std::nullopt : std::optional(fmt::format(" id=\"{}\"", ids.front()));
    }
    if (type.needs_channel) {
      const auto channels = free_channels(reading_, segment, channel_count(reading_, segment));
      return channels.empty() ? std::nullopt : std::optional(fmt::format(" channel=\"{}\"", channels.front()));
    }
    return type.needs_address && !type.default_address ? " address=\"...\"" : "";
  }

  const Reading& reading_;
  const Device& parent_;
  std::size_t role_;
};

/// Roots that would fit and stand elsewhere: probably the child that is missed.
std::string lonely_devices(const Reading& reading, DeviceId parent, const RoleSpec& role) {
  if (role.interface == "any") return {};
  DeviceId root = parent;
  for (std::size_t steps = 0; reading.robot.devices[root].parent && steps < reading.robot.devices.size(); ++steps)
    root = *reading.robot.devices[root].parent;
  std::string list;
  for (const DeviceId i : reading.robot.devices.ids()) {
    const Device& device = reading.robot.devices[i];
    if (device.parent || i == root || device.type == nullptr || !satisfies(*device.type, role)) continue;
    list += (list.empty() ? "'" : ", '") + device.name.text + "'";
  }
  return list;
}

/// Sensors of other branches and trees that would fit: where the reader needs their data alone, it can read them there.
std::string readable_devices(const Reading& reading, DeviceId reader, const RoleSpec& role) {
  if (role.interface == "any") return {};
  const Robot& robot = reading.robot;
  std::string list;
  for (const DeviceId i : robot.devices.ids()) {
    const Device& device = robot.devices[i];
    const bool fits = device.parent && device.type != nullptr && device.type->roles.empty() && !device.type->actuator &&
                      satisfies(*device.type, role);
    const bool is_read = std::any_of(robot.devices[reader].reads.begin(), robot.devices[reader].reads.end(),
                                     [&](const Read& read) { return read.device == i; });
    if (!fits || is_read || is_descendant(robot, reader, i) || is_descendant(robot, i, reader)) continue;
    list +=
        fmt::format("{}<reads device=\"{}\" role=\"{}\"/>", list.empty() ? "" : " or ", device.name.text, role.name);
  }
  return list;
}

void report_too_few(Reading& reading, DeviceId index, std::size_t role, std::size_t given) {
  const Device& device = reading.robot.devices[index];
  const RoleSpec& spec = device.type->roles[role];
  auto& finding = at_tag(
      reading.diagnostics, code::role_too_few, reading.device_tag(index),
      fmt::format("device '{}' needs {} in the role '{}' and has {}", device.name.text, spec.min, spec.name, given));
  const std::vector<const DeviceType*> types = fitting_types(reading, spec);
  std::string names;
  for (const DeviceType* type : types) names += (names.empty() ? "'" : ", '") + type->name + "'";
  if (!names.empty()) finding.note(fmt::format("the role takes what provides '{}': {}", spec.interface, names));
  const std::string lonely = lonely_devices(reading, index, spec);
  if (!lonely.empty())
    finding.hint(
        fmt::format("{} would fit and has no parent: nest it here, or add parent=\"{}\"", lonely, device.name.text));
  const std::string readable = readable_devices(reading, index, spec);
  if (!readable.empty()) finding.hint("let it read what is elsewhere: " + readable);
  finding.hint("nest in it for example " + MissingChild(reading, index, role).text(types));
}

void check_role(Reading& reading, DeviceId index, std::size_t role, bool may_be_elsewhere) {
  const Device& device = reading.robot.devices[index];
  const RoleSpec& spec = device.type->roles[role];
  std::vector<Position> members;
  for (const DeviceId child : device.children) {
    if (reading.robot.devices[child].role == role) members.push_back(reading.robot.devices[child].at);
  }
  for (const Read& read : device.reads) {
    if (read.role == role) members.push_back(read.at);
  }
  if (spec.max && members.size() > *spec.max) {
    reading.diagnostics
        .error(code::role_too_many, members[*spec.max],
               fmt::format("device '{}' takes {} in the role '{}', this is number {}", device.name.text, *spec.max,
                           spec.name, *spec.max + 1))
        .underline(7)
        .note(fmt::format("{} are given", members.size()));
  }
  if (members.size() < spec.min && !reading.devices[index].is_incomplete && !may_be_elsewhere)
    report_too_few(reading, index, role, members.size());
}

}  // namespace

void check_arities(Reading& reading) {
  // a device whose parent="..." names nothing may be the one that is missed
  const bool has_lost_child = std::any_of(reading.devices.begin(), reading.devices.end(),
                                          [](const Reading::DeviceState& state) { return state.parent_is_wrong; });
  for (const DeviceId i : reading.robot.devices.ids()) {
    const DeviceType* type = reading.robot.devices[i].type;
    for (std::size_t role = 0; type != nullptr && role < type->roles.size(); ++role)
      check_role(reading, i, role, has_lost_child);
  }
}

}  // namespace finemote::gen
