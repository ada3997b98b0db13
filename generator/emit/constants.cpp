#include "generator/emit/constants.hpp"

#include <fmt/format.h>

#include "generator/emit/geometry.hpp"
#include "generator/emit/number.hpp"

namespace finemote::gen {
namespace {

std::vector<Axis> actuator_axes(const Plan& plan, std::size_t owner, const std::string& role, Diagnostics& diagnostics) {
  std::vector<Axis> axes;
  const Device& device = plan.robot.devices[owner];
  for (std::size_t child : device.children) {
    const Device& actuator = plan.robot.devices[child];
    if (!actuator.role || device.type->roles[*actuator.role].name != role) continue;
    if (actuator.joint.empty()) {
      diagnostics
          .error(code::geometry_without_joint, actuator.at,
                 fmt::format("device '{}' needs a 'joint': '{}' computes its place and direction from it",
                             actuator.name.text, device.name.text))
          .hint("add joint=\"...\" with the name of the joint that carries it");
      continue;
    }
    if (const auto axis = joint_axis(plan.robot, actuator.joint)) axes.push_back(*axis);
  }
  return axes;
}

std::string allocation_text(const Plan& plan, std::size_t owner, const GeometrySpec& spec, const std::string& name,
                            const std::vector<Axis>& axes) {
  const Eigen::MatrixXd matrix = allocation(axes);
  std::string text = fmt::format(
      "/// Allocation of '{}': force of each of its {} (rows) for a wrench fx fy fz [N] mx my mz [Nm] in the base frame.\n",
      plan.robot.devices[owner].name.text, spec.role);
  text += fmt::format("inline constexpr float {}[{}][6] = {{\n", name, matrix.rows());
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    text += "    {";
    for (Eigen::Index k = 0; k < 6; ++k) text += (k > 0 ? ", " : "") + float_literal(matrix(row, k));
    text += "},\n";
  }
  return text + "};";
}

}  // namespace

std::vector<Constant> make_constants(const Plan& plan, Diagnostics& diagnostics) {
  std::vector<Constant> constants;
  for (std::size_t owner : plan.forest.order) {
    const Device& device = plan.robot.devices[owner];
    for (const GeometrySpec& spec : device.type->geometry) {
      if (spec.kind != "allocation") {
        diagnostics.error(code::unknown_geometry, device.at,
                          fmt::format("device type '{}' asks for geometry of kind '{}', which this version does not know",
                                      device.type->name, spec.kind))
            .hint("valid here: 'allocation'");
        continue;
      }
      const std::vector<Axis> axes = actuator_axes(plan, owner, spec.role, diagnostics);
      if (axes.empty()) continue;
      const std::string name = device.name.cpp + "_" + spec.kind;
      constants.push_back({owner, name, allocation_text(plan, owner, spec, name, axes)});
    }
  }
  return constants;
}

}  // namespace finemote::gen
