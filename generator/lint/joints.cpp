#include "generator/lint/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/geometry/angle.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/geometry/role_joints.hpp"
#include "generator/lint/codes.hpp"

namespace finemote::gen {
namespace {

constexpr double kOnePlace = 1e-3;  // m

/// One geometry entry of one device, with its joints.
class JointLint {
 public:
  JointLint(const Robot& robot, const Device& device, const GeometrySpec& geometry, std::vector<Diagnostic>& findings)
      : robot_(robot),
        mechanism_(robot),
        device_(device),
        geometry_(geometry),
        joints_(role_joints(robot, device, geometry)),
        link_(joints_.empty() ? std::string() : geometry_link(mechanism_, device, geometry, joints_)),
        findings_(findings) {}

  void run() {
    if (joints_.empty()) return;
    if (is_about_body(geometry_)) check_turning();
    if (is_about_body(geometry_)) check_moved();
    if (is_about_body(geometry_)) check_sensors();
    if (geometry_.kind == "allocation") check_places();
    if (geometry_.kind == "chain") check_chain();
    if (geometry_.kind == "axes" && !geometry_.carries.empty()) check_carried();
    if (geometry_.kind == "range") check_params();
  }

 private:
  Diagnostic& report(LintCode code, const Device& at, std::string message) {
    findings_.push_back({Severity::warning, code.code, at.at, 7, std::move(message), {}, {}});
    return findings_.back();
  }
  [[nodiscard]] const Device* driver_of(const std::string& joint) const {
    const auto found = std::find_if(robot_.devices.begin(), robot_.devices.end(), [&](const Device& device) {
      return device.joint == joint && (device.type->actuator || device.type->has_command());
    });
    return found == robot_.devices.end() ? nullptr : &*found;
  }
  [[nodiscard]] const Device& child_of(const std::string& joint) const {
    const auto found = std::find_if(device_.children.begin(), device_.children.end(),
                                    [&](std::size_t child) { return robot_.devices[child].joint == joint; });
    return robot_.devices[*found];
  }

  /// A joint between two links, on either side, that a device turns, itself or by a joint it follows; null: none.
  [[nodiscard]] const Joint* moving_between(const std::string& link, const std::string& other) const {
    const auto way = mechanism_.way_to(link), way_other = mechanism_.way_to(other);
    if (!way || !way_other) return nullptr;
    const auto shared = std::mismatch(way->begin(), way->end(), way_other->begin(), way_other->end());
    const auto is_moved = [&](const Joint* joint) {
      return driver_of(joint->mimic.empty() ? joint->name : joint->mimic) != nullptr;
    };
    const auto own = std::find_if(shared.first, way->end(), is_moved);
    if (own != way->end()) return *own;
    const auto theirs = std::find_if(shared.second, way_other->end(), is_moved);
    return theirs == way_other->end() ? nullptr : *theirs;
  }
  [[nodiscard]] const Device& mover_of(const Joint& joint) const {
    return *driver_of(joint.mimic.empty() ? joint.name : joint.mimic);
  }

  void check_turning() {
    for (const std::string& name : joints_) {
      const Joint& joint = *mechanism_.joint(name);
      const auto limits = limits_of(joint);
      if (!limits || limits->upper - limits->lower >= 2 * M_PI) continue;
      report(code::lint_wheel_limits, child_of(name),
             fmt::format("joint '{}', one of the {} of device '{}', cannot turn round", name, geometry_.role,
                         device_.name.text))
          .note(fmt::format("it is revolute, from {:g} to {:g} rad", limits->lower, limits->upper))
          .note("the joint is declared here", joint.at)
          .hint("write type=\"continuous\" in the tag of the joint");
    }
  }

  void check_moved() {
    for (const std::string& name : joints_) {
      const Joint* moved = moving_between(mechanism_.joint(name)->parent_link, link_);
      if (moved == nullptr) continue;
      report(code::lint_moved_joint, child_of(name),
             fmt::format("joint '{}' moves joint '{}', one of the {} of device '{}'", moved->name, name, geometry_.role,
                         device_.name.text))
          .note(fmt::format("device '{}' drives it", mover_of(*moved).name.text), mover_of(*moved).at)
          .note(fmt::format("the constants of device '{}' are those with that joint at zero", device_.name.text))
          .hint("hang it on the body, or see to it that the joint stays at zero while the device drives");
    }
  }

  void check_places() {
    for (std::size_t n = 0; n < joints_.size(); ++n) {
      for (std::size_t before = 0; before < n; ++before) check_place(joints_[before], joints_[n]);
    }
  }
  void check_place(const std::string& before, const std::string& name) {
    const auto first = joint_axis(mechanism_, before, link_), second = joint_axis(mechanism_, name, link_);
    const bool is_same = (first->point - second->point).norm() < kOnePlace &&
                         angle_off(first->direction, second->direction) <= radians(geometry_.tolerance_deg);
    if (!is_same) return;
    report(code::lint_same_place, child_of(name),
           fmt::format("joints '{}' and '{}' are in the same place and on the same axis", before, name))
        .note(fmt::format("for the allocation of device '{}' they are one of its {}, counted twice", device_.name.text,
                          geometry_.role))
        .note("the first is declared here", mechanism_.joint(before)->at)
        .note("the second is declared here", mechanism_.joint(name)->at)
        .hint("correct one of the origins; for two rotors on one shaft allow FM3167");
  }

  void check_chain() {
    const auto links = chain(mechanism_, joints_, link_);
    const bool has_mass = std::any_of(links.begin(), links.end(), [](const ChainLink& link) { return link.mass > 0; });
    const bool carries = geometry_.param.empty() || geometry_param(device_, geometry_) != 0;
    if (!has_mass && carries) {
      Diagnostic& finding =
          report(code::lint_no_mass, device_,
                 fmt::format("nothing that the {} of device '{}' move has a mass", geometry_.role, device_.name.text));
      finding.note("the weight it carries is computed from the <inertial> of the links, and is 0")
          .hint("add an <inertial> with the mass of each link");
      if (!geometry_.param.empty())
        finding.hint(fmt::format("if the weight is balanced, add <param name=\"{}\">0</param>", geometry_.param));
    }
    for (std::size_t n = 1; n < joints_.size(); ++n) {
      const Joint* moved =
          moving_between(mechanism_.joint(joints_[n])->parent_link, mechanism_.joint(joints_[n - 1])->child_link);
      if (moved == nullptr) continue;
      report(code::lint_moved_joint, device_,
             fmt::format("joint '{}' lies between joints '{}' and '{}', and is none of the {} of device '{}'",
                         moved->name, joints_[n - 1], joints_[n], geometry_.role, device_.name.text))
          .note(fmt::format("device '{}' drives it", mover_of(*moved).name.text), mover_of(*moved).at)
          .note("the weight is computed with that joint at zero")
          .hint(fmt::format("make what drives it one of the {}, in its place", geometry_.role));
    }
  }

  /// Sensors that say where their link is, and whose data depend on how it is turned.
  template <typename Check>
  void each_sensor(const Check& check) {
    const auto visit = [&](std::size_t index, std::size_t role) {
      const Device& sensor = robot_.devices[index];
      const auto& all = sensor.type->geometry;
      const bool is_mounted =
          std::any_of(all.begin(), all.end(), [](const GeometrySpec& spec) { return spec.kind == "mount"; });
      if (is_mounted && !sensor.link.empty()) check(sensor, device_.type->roles[role].name);
    };
    for (const std::size_t child : device_.children) {
      if (robot_.devices[child].role) visit(child, *robot_.devices[child].role);
    }
    for (const Read& read : device_.reads) visit(read.device, read.role);
  }

  void check_sensors() {
    each_sensor([&](const Device& sensor, const std::string& role) {
      const Joint* moved = moving_between(sensor.link, link_);
      if (moved == nullptr) return;
      report(code::lint_sensor_place, sensor,
             fmt::format("joint '{}' moves device '{}', the {} of device '{}', against the body", moved->name,
                         sensor.name.text, role, device_.name.text))
          .note(fmt::format("the body is link '{}'", link_))
          .note(fmt::format("device '{}' drives the joint", mover_of(*moved).name.text), mover_of(*moved).at)
          .hint(fmt::format("use a sensor that is fixed to link '{}'", link_));
    });
  }

  void check_carried() {
    each_sensor([&](const Device& sensor, const std::string& role) {
      if (role != geometry_.carries) return;
      const auto way = mechanism_.way_to(sensor.link);
      const bool is_carried = way && std::any_of(way->begin(), way->end(),
                                                 [&](const Joint* joint) { return joint->name == joints_.back(); });
      if (is_carried) return;
      report(code::lint_sensor_place, sensor,
             fmt::format("device '{}', the {} of device '{}', is not on what the {} turns", sensor.name.text, role,
                         device_.name.text, geometry_.role))
          .note(fmt::format("its link '{}' is not behind joint '{}'", sensor.link, joints_.back()))
          .hint(fmt::format("write link=\"{}\" if it is there, or hang its link on that one",
                            mechanism_.joint(joints_.back())->child_link));
    });
  }

  void check_params() {
    const Range allowed = allowed_range(device_, geometry_);
    const double tolerance = radians(geometry_.tolerance_deg);
    for (const std::string& name : joints_) {
      const auto limits = limits_along(mechanism_, device_, geometry_, name);
      if (!limits) continue;
      if (allowed.lower < limits->lower - tolerance) report_param(geometry_.lowest, name, *limits, allowed.lower);
      if (allowed.upper > limits->upper + tolerance) report_param(geometry_.highest, name, *limits, allowed.upper);
    }
  }
  void report_param(const std::string& param, const std::string& joint, const Range& limits, double value) {
    const bool is_given = std::any_of(device_.params.begin(), device_.params.end(),
                                      [&](const Param& entry) { return entry.spec->name == param && entry.given; });
    if (!is_given) return;
    report(code::lint_param_range, device_,
           fmt::format("param '{}' of device '{}' is beyond the limits of joint '{}'", param, device_.name.text, joint))
        .note(fmt::format("it is {:g} rad; about {}, the joint turns from {:g} to {:g} rad, and no further", value,
                          geometry_.along, limits.lower, limits.upper))
        .note("the joint is declared here", mechanism_.joint(joint)->at)
        .hint(fmt::format("write <param name=\"{}\">{:g}rad</param>, or correct the limits of the joint", param,
                          param == geometry_.lowest ? limits.lower : limits.upper));
  }

  const Robot& robot_;
  Mechanism mechanism_;
  const Device& device_;
  const GeometrySpec& geometry_;
  std::vector<std::string> joints_;
  std::string link_;
  std::vector<Diagnostic>& findings_;
};

}  // namespace

std::vector<Diagnostic> joint_findings(const Robot& robot, const Device& device) {
  std::vector<Diagnostic> findings;
  for (const GeometrySpec& geometry : device.type->geometry) JointLint(robot, device, geometry, findings).run();
  return findings;
}

}  // namespace finemote::gen
