#include "generator/emit/constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/number.hpp"
#include "generator/geometry/allocation.hpp"
#include "generator/geometry/chain.hpp"
#include "generator/geometry/role_joints.hpp"
#include "generator/geometry/rolling.hpp"

namespace finemote::gen {
namespace {

std::string numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + float_literal(value);
  return text;
}
std::string braced(const Eigen::Vector3d& v) { return "{" + numbers({v.x(), v.y(), v.z()}) + "}"; }

std::vector<Axis> axes_of(const Mechanism& mechanism, const std::vector<std::string>& joints) {
  std::vector<Axis> axes;
  for (const std::string& joint : joints) axes.push_back(*joint_axis(mechanism, joint));
  return axes;
}

/// A definition with one line per entry.
std::string list(const std::string& comment, const std::string& head, const std::vector<std::string>& lines) {
  std::string text = "/// " + comment + "\ninline constexpr " + head + " = {\n";
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
  [[nodiscard]] std::string head(const char* type, const char* row = "") const {
    return fmt::format("{} {}[{}]{}", type, name, joints.size(), row);
  }
};

std::string allocation_text(const Request& request) {
  const Eigen::MatrixXd matrix = allocation(axes_of(request.mechanism, request.joints));
  std::vector<std::string> lines;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    lines.push_back(
        numbers({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3), matrix(row, 4), matrix(row, 5)}));
  return list(fmt::format("Allocation of '{}': force of each of its {} (rows) for a wrench fx fy fz [N] mx my mz [Nm] "
                          "in the base frame.",
                          request.owner, request.role),
              request.head("float", "[6]"), lines);
}

std::string rolling_text(const Request& request) {
  const Rolling all = rolling(axes_of(request.mechanism, request.joints));
  std::vector<std::string> lines;
  for (Eigen::Index n = 0; n < all.rows.rows(); ++n)
    lines.push_back(numbers(
        {all.rows(n, 0), all.rows(n, 1), all.rows(n, 2), all.columns(0, n), all.columns(1, n), all.columns(2, n)}));
  return list(fmt::format("Rolling of the {} of '{}' for forward [m/s], left [m/s], turn [rad/s], and their shares in "
                          "the base's motion.",
                          request.role, request.owner),
              request.head("finemote::RollingWheel"), lines);
}

std::string chain_text(const Request& request) {
  std::vector<std::string> lines;
  for (const ChainLink& link : chain(request.mechanism, request.joints))
    lines.push_back(fmt::format("{}, {}, {}, {}", braced(link.offset), braced(link.axis), braced(link.centre),
                                float_literal(link.mass)));
  return list(fmt::format("Joints of the {} of '{}': offset [m], axis, centre of mass [m], mass [kg].", request.role,
                          request.owner),
              request.head("finemote::ChainLink"), lines);
}

std::string axes_text(const Request& request) {
  std::vector<std::string> lines;
  for (const Axis& axis : axes_of(request.mechanism, request.joints))
    lines.push_back(numbers({axis.direction.x(), axis.direction.y(), axis.direction.z()}));
  return list(fmt::format("Joint axis of the {} of '{}'.", request.role, request.owner),
              request.head("finemote::Vector"), lines);
}

/// Empty where the device has no link, or one that is not turned.
std::string mount_text(const Mechanism& mechanism, const Device& device, const std::string& name) {
  const auto pose = device.link.empty() ? std::nullopt : mechanism.pose(device.link);
  if (!pose || pose->linear().isIdentity(1e-9)) return {};
  std::string rows;
  for (int i = 0; i < 3; ++i) rows += (i > 0 ? ", " : "") + braced(Eigen::Vector3d(pose->linear().row(i).transpose()));
  return list(fmt::format("How '{}' is turned: its axes to those of the root link.", device.name.text),
              fmt::format("finemote::Rotation {}[1]", name), {"{" + rows + "}"});
}

std::string text_of(const Plan& plan, const Device& device, const GeometrySpec& spec, const std::string& name) {
  const Mechanism mechanism(plan.robot);
  if (spec.kind == "mount") return mount_text(mechanism, device, name);
  const std::vector<std::string> joints = role_joints(plan.robot, device, spec);
  if (joints.empty()) return {};
  const Request request{mechanism, device.name.text, spec.role, name, joints};
  if (spec.kind == "rolling") return rolling_text(request);
  if (spec.kind == "chain") return chain_text(request);
  if (spec.kind == "axes") return axes_text(request);
  return allocation_text(request);  // the descriptor's schema allows no other
}

/// `rov_allocation`; with its role where the type asks for the kind more than once: `head_yaw_axes`.
std::string name_of(const Device& device, const GeometrySpec& spec) {
  const auto& all = device.type->geometry;
  const auto same = std::count_if(all.begin(), all.end(), [&](const GeometrySpec& s) { return s.kind == spec.kind; });
  return device.name.cpp + "_" + (same > 1 ? spec.role + "_" : "") + spec.kind;
}

}  // namespace

std::vector<Constant> make_constants(const Plan& plan) {
  std::vector<Constant> constants;
  for (const std::size_t owner : plan.forest.order) {
    const Device& device = plan.robot.devices[owner];
    for (const GeometrySpec& spec : device.type->geometry) {
      const std::string name = name_of(device, spec);
      const char* header = spec.kind == "allocation" ? "" : "<finemote/geometry.hpp>";
      constants.push_back({owner, name, text_of(plan, device, spec, name), false, header});
    }
  }
  return constants;
}

}  // namespace finemote::gen
