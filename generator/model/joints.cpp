// `link` and `joint` of devices against the URDF: FM2002 to FM2004, FM2011, FM2013, FM2014.
#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/fit.hpp"
#include "generator/geometry/range.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

constexpr double kShortestAxis = 1e-9;  // any shorter one is none

template <typename Entry>
std::vector<std::string> names_of(const std::vector<Entry>& list) {
  std::vector<std::string> names;
  for (const Entry& entry : list) names.push_back(entry.name);
  return names;
}

bool drives(const Device& device) {
  return device.type != nullptr && (device.type->actuator || device.type->has_command());
}

void check_link(Reading& reading, const xml::Node& tag) {
  const xml::Attribute* link = tag.attribute("link");
  if (link == nullptr || reading.kinematics.link(link->value) != nullptr) return;
  suggest(at_value(reading.diagnostics, code::unknown_link, *link, fmt::format("there is no link '{}'", link->value)),
          link->value, names_of(reading.kinematics.links));
}

/// Is one of the two, at any depth, a child of the other? Then they drive the joint together.
bool is_related(const Reading& reading, DeviceId one, DeviceId other) {
  const auto is_above = [&](DeviceId above, DeviceId below) {
    std::optional<DeviceId> device = below;
    for (std::size_t steps = 0; device && steps <= reading.robot.devices.size(); ++steps) {
      if (*device == above) return true;
      device = reading.robot.devices[*device].parent;
    }
    return false;
  };
  return is_above(one, other) || is_above(other, one);
}

/// What drives the joint of device `index` and stands before it.
const Device* other_driver(const Reading& reading, DeviceId index) {
  for (const DeviceId other : reading.robot.devices.ids()) {
    if (other == index) break;
    const Device& device = reading.robot.devices[other];
    const bool is_same = device.joint == reading.robot.devices[index].joint;
    if (is_same && drives(device) && !is_related(reading, other, index)) return &device;
  }
  return nullptr;
}

/// What speaks against driving a joint, whatever for.
class DrivenJoint {
 public:
  DrivenJoint(Reading& reading, DeviceId index, const Joint& joint)
      : reading_(reading),
        index_(index),
        device_(reading.robot.devices[index]),
        name_(*reading.device_tag(index).attribute("joint")),
        joint_(joint) {}

  void check() {
    if (joint_.type == "fixed") return report_fixed();
    if (!joint_.mimic.empty()) return report_mimic();
    if (const Device* other = other_driver(reading_, index_)) return report_second(*other);
    const auto& a = joint_.axis;
    if (Eigen::Vector3d(a[0], a[1], a[2]).norm() < kShortestAxis) return report_no_axis();
    if (joint_.lower.value_or(0) > joint_.upper.value_or(0)) return report_no_position(reading_, index_);
    for (const GeometrySpec& geometry : device_.type->geometry) {
      if (geometry.kind == "range" && geometry.role.empty()) check_range(geometry);
    }
  }

 private:
  Diagnostic& report(Code code, std::string message) {
    reading_.devices[index_].joint_is_wrong = true;
    return at_value(reading_.diagnostics, code, name_, std::move(message));
  }
  Diagnostic& report_unfit() {
    return report(code::joint_unfit,
                  fmt::format("joint '{}' cannot be driven by device '{}'", joint_.name, device_.name.text));
  }
  void report_fixed() {
    if (!device_.type->actuator) return;
    report(code::joint_fixed,
           fmt::format("joint '{}' is fixed, but device '{}' moves it", joint_.name, device_.name.text))
        .note("the joint is declared here", joint_.at)
        .hint("make the joint type=\"continuous\" for what spins, \"revolute\" or \"prismatic\" for what has an end");
  }
  void report_mimic() {
    const auto& devices = reading_.robot.devices;
    const bool is_driven = std::any_of(devices.begin(), devices.end(), [&](const Device& device) {
      return drives(device) && device.joint == joint_.mimic;
    });
    report_unfit()
        .note(fmt::format("it follows joint '{}' (<mimic>), and has no motion of its own", joint_.mimic))
        .note("the joint is declared here", joint_.at)
        .hint(is_driven ? "remove the device, or the <mimic> if the joint has a drive of its own"
                        : fmt::format("write joint=\"{}\", or remove the <mimic> if the joint has a drive of its own",
                                      joint_.mimic));
  }
  void report_second(const Device& other) {
    report_unfit()
        .note(fmt::format("device '{}' drives it already", other.name.text), other.at)
        .hint("name the joint that this one drives; for two motors that share a joint add a joint in the URDF");
  }
  void report_no_axis() {
    report(code::axis_direction, fmt::format("the axis of joint '{}' has no direction", joint_.name))
        .note("the joint is declared here", joint_.at)
        .hint("write for example <axis xyz=\"0 0 1\"/>");
  }
  void check_range(const GeometrySpec& geometry) {
    if (!turns(joint_)) {
      report_unfit()
          .note(fmt::format("it is {}; a joint that turns is revolute or continuous", joint_.type))
          .note("the joint is declared here", joint_.at);
      return;
    }
    const auto limits = limits_of(joint_);
    if (!limits) return;
    if (limits->lower >= limits->upper) return report_no_position(reading_, index_);
    const double travel = geometry_param(device_.params, geometry);
    const Range range = within_travel(*limits, travel);
    if (range.lower < range.upper) return;
    report(code::joint_limits,
           fmt::format("device '{}' reaches no angle within the limits of joint '{}'", device_.name.text, joint_.name))
        .note(fmt::format("the joint turns from {:g} to {:g} rad, the device from {:.4g} to {:.4g} rad", limits->lower,
                          limits->upper, -travel / 2, travel / 2))
        .note("the joint is declared here", joint_.at)
        .hint(fmt::format("measure the joint's angle from the middle of the travel, or set '{}'", geometry.param));
  }

  Reading& reading_;
  DeviceId index_;
  const Device& device_;
  const xml::Attribute& name_;
  const Joint& joint_;
};

void check_joint(Reading& reading, DeviceId index) {
  const xml::Attribute* name = reading.device_tag(index).attribute("joint");
  if (name == nullptr) return;
  const Joint* joint = reading.kinematics.joint(name->value);
  if (joint != nullptr) {
    reading.devices[index].joint_is_wrong = reading.kinematics.wrong_joints.count(joint->name) > 0;
    if (reading.devices[index].joint_is_wrong) return;  // what it can be is not known
    if (drives(reading.robot.devices[index])) DrivenJoint(reading, index, *joint).check();
    return;
  }
  reading.devices[index].joint_is_wrong = true;
  suggest(at_value(reading.diagnostics, code::unknown_joint, *name, fmt::format("there is no joint '{}'", name->value)),
          name->value, names_of(reading.kinematics.joints));
}

}  // namespace

void report_no_position(Reading& reading, DeviceId device) {
  const Joint& joint = *reading.kinematics.joint(reading.robot.devices[device].joint);
  reading.devices[device].joint_is_wrong = true;
  at_value(reading.diagnostics, code::joint_limits, *reading.device_tag(device).attribute("joint"),
           fmt::format("the limits of joint '{}' leave it no position", joint.name))
      .note(fmt::format("lower is {:g}{}, upper is {:g}{}", joint.lower.value_or(0), joint.lower ? "" : " by default",
                        joint.upper.value_or(0), joint.upper ? "" : " by default"))
      .note("the joint is declared here", joint.at)
      .hint("write lower and upper so that lower < upper");
}

void check_joints(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    check_link(reading, reading.device_tag(i));
    check_joint(reading, i);
  }
  for (const DeviceId i : reading.robot.devices.ids()) check_geometry(reading, i);
}

}  // namespace finemote::gen
