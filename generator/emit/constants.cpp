#include "generator/emit/constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/diagnostic/printable.hpp"
#include "generator/emit/number.hpp"
#include "generator/geometry/allocation.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/geometry/rolling.hpp"
#include "generator/model/device_frames.hpp"

namespace finemote::gen {
namespace {

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + float_literal(value);
  return text;
}
std::string braced(const Eigen::Vector3d& v) { return "{" + numbers({v.x(), v.y(), v.z()}) + "}"; }

/// A definition with one line per entry.
std::string list(const std::vector<std::string>& comment, const std::string& head,
                 const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : comment) text += "/// " + printable(line) + "\n";
  text += "inline constexpr " + head + " = {\n";
  for (const std::string& line : lines) text += "    {" + line + "},\n";
  return text + "};";
}

/// What every kind is written from.
struct Request {
  const Mechanism& mechanism;
  const std::string& owner;  ///< as in the URDF
  const std::string& role;
  const std::string& name;  ///< of the constant
  const std::vector<std::string>& joints;
  const std::string link;  ///< whose frame it is in
  [[nodiscard]] std::string head(const char* type, const char* row = "") const {
    return fmt::format("{} {}[{}]{}", type, name, joints.size(), row);
  }
  [[nodiscard]] std::vector<Axis> axes() const {
    std::vector<Axis> axes;
    for (const std::string& joint : joints) axes.push_back(joint_axis(mechanism, joint, link).value());
    return axes;
  }
};

std::string allocation_text(const Request& request) {
  const Eigen::MatrixXd matrix = allocation(request.axes());
  std::vector<std::string> lines;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    lines.push_back(
        numbers({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3), matrix(row, 4), matrix(row, 5)}));
  return list(
      {fmt::format("Allocation of '{}': force [N] of each of its {} (rows) for a wrench fx fy fz [N] mx my mz [Nm]",
                   request.owner, request.role),
       fmt::format("in the axes of link '{}' and about its origin.", request.link)},
      request.head("float", "[6]"), lines);
}

std::string rolling_text(const Request& request) {
  const Rolling all = rolling(request.axes());
  std::vector<std::string> lines;
  for (Eigen::Index n = 0; n < all.rows.rows(); ++n)
    lines.push_back(numbers(
        {all.rows(n, 0), all.rows(n, 1), all.rows(n, 2), all.columns(0, n), all.columns(1, n), all.columns(2, n)}));
  return list({fmt::format("Rolling of the {} of '{}' for forward [m/s], left [m/s], turn [rad/s], and their shares in "
                           "the base's motion:",
                           request.role, request.owner),
               fmt::format("in the axes of link '{}' and about its origin.", request.link)},
              request.head("finemote::RollingWheel"), lines);
}

std::string chain_text(const Request& request) {
  std::vector<std::string> lines;
  for (const ChainLink& link : chain(request.mechanism, request.joints, request.link))
    lines.push_back(fmt::format("{}, {}, {}, {}", braced(link.offset), braced(link.axis), braced(link.centre),
                                float_literal(link.mass)));
  return list(
      {fmt::format("Joints of the {} of '{}': offset [m], axis, centre of mass [m], mass [kg]; in the axes of link "
                   "'{}'.",
                   request.role, request.owner, request.link)},
      request.head("finemote::ChainLink"), lines);
}

std::string axes_text(const Request& request) {
  std::vector<std::string> lines;
  for (const Axis& axis : request.axes())
    lines.push_back(numbers({axis.direction.x(), axis.direction.y(), axis.direction.z()}));
  return list({fmt::format("Joint axis of the {} of '{}', in the axes of link '{}'.", request.role, request.owner,
                           request.link)},
              request.head("finemote::Vector"), lines);
}

/// Empty where the device has no link, or one that is not turned.
std::string mount_text(const Robot& robot, const Mechanism& mechanism, DeviceId index, const std::string& name) {
  const Device& device = robot.devices[index];
  const std::string link = mount_link(robot, index);
  const auto pose = device.link.empty() ? std::nullopt : mechanism.pose(device.link, link);
  if (!pose || pose->linear().isIdentity(1e-9)) return {};
  std::string rows;
  for (int i = 0; i < 3; ++i) rows += (i > 0 ? ", " : "") + braced(Eigen::Vector3d(pose->linear().row(i).transpose()));
  return list({fmt::format("How '{}' is turned: its axes to those of link '{}'.", device.name.text, link)},
              fmt::format("finemote::Rotation {}[1]", name), {"{" + rows + "}"});
}

/// Empty where the device has no joint, or one without limits.
std::string range_text(const Mechanism& mechanism, const Device& device, const GeometrySpec& spec,
                       const std::string& name) {
  const Joint* joint = mechanism.joint(device.joint);
  const auto limits = joint == nullptr ? std::nullopt : limits_of(*joint);
  if (!limits) return {};
  const Range range = within_travel(*limits, geometry_param(device.params, spec));
  return list(
      {fmt::format("How far joint '{}' turns within the travel of '{}' [rad].", device.joint, device.name.text)},
      fmt::format("finemote::JointRange {}[1]", name), {numbers({range.lower, range.upper})});
}

/// Empty where none of the joints has limits.
std::string role_range_text(const Request& request, const Device& device, const GeometrySpec& spec) {
  std::vector<std::string> lines;
  for (const Range& range : role_ranges(request.mechanism, device.link, device.params, spec, request.joints))
    lines.push_back(numbers({range.lower, range.upper}));
  if (lines.empty()) return {};
  const std::string about = spec.along.empty() ? "" : fmt::format(" about {} of link '{}'", spec.along, request.link);
  return list({fmt::format("How far the {} of '{}' may turn{} [rad].", request.role, request.owner, about)},
              request.head("finemote::JointRange"), lines);
}

std::string text_of(const Plan& plan, DeviceId owner, const GeometrySpec& spec, const std::string& name) {
  const Mechanism mechanism(plan.robot.links, plan.robot.joints);
  const Device& device = plan.robot.devices[owner];
  if (spec.kind == "mount") return mount_text(plan.robot, mechanism, owner, name);
  if (spec.kind == "range" && spec.role.empty()) return range_text(mechanism, device, spec, name);
  const std::vector<std::string> joints = role_joints(plan.robot, device, spec);
  if (joints.empty()) return {};
  const std::string link = geometry_link(mechanism, device.link, spec, joints);
  const Request request{mechanism, device.name.text, spec.role, name, joints, link};
  if (spec.kind == "rolling") return rolling_text(request);
  if (spec.kind == "chain") return chain_text(request);
  if (spec.kind == "axes") return axes_text(request);
  if (spec.kind == "range") return role_range_text(request, device, spec);
  return allocation_text(request);  // the descriptor's schema allows no other
}

/// `rov_allocation`; with its role where the type asks for the kind more than once: `head_yaw_axes`.
std::string name_of(const Device& device, const GeometrySpec& spec) {
  const auto& all = device.type->geometry;
  const auto same = std::count_if(all.begin(), all.end(), [&](const GeometrySpec& s) { return s.kind == spec.kind; });
  return device.name.cpp + "_" + (same > 1 ? spec.role + "_" : "") + spec.kind;
}

}  // namespace

std::vector<Constant> make_constants(const Plan& plan, Diagnostics& diagnostics) {
  std::vector<Constant> constants;
  for (const DeviceId owner : plan.forest.order) {
    const Device& device = plan.robot.devices[owner];
    for (const GeometrySpec& spec : device.type->geometry) {
      const std::string name = name_of(device, spec);
      const char* header = spec.kind == "allocation" ? "" : "<finemote/geometry.hpp>";
      try {
        constants.push_back({owner, name, text_of(plan, owner, spec, name), false, header});
      } catch (const NoFloat& problem) {
        diagnostics
            .error(code::geometry_number, device.at,
                   fmt::format("the constant '{}' of device '{}' holds {}", name, device.name.text, problem.what()))
            .underline(7)
            .note(
                "it is computed from the links and joints of the robot: one of their numbers is far from any real one");
      }
    }
  }
  return constants;
}

}  // namespace finemote::gen
