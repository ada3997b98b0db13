#include "generator/emit/constants.hpp"

#include <fmt/format.h>

#include "generator/emit/geometry.hpp"
#include "generator/emit/number.hpp"

namespace finemote::gen {
namespace {

std::vector<Axis> actuator_axes(const Plan& plan, std::size_t owner, const std::string& role) {
  std::vector<Axis> axes;
  const Device& device = plan.robot.devices[owner];
  for (std::size_t child : device.children) {
    const Device& actuator = plan.robot.devices[child];
    if (!actuator.role || device.type->roles[*actuator.role].name != role) continue;
    if (const auto axis = joint_axis(plan.robot, actuator.joint)) axes.push_back(*axis);
  }
  return axes;
}

std::string allocation_text(const Plan& plan, std::size_t owner, const GeometrySpec& spec, const std::string& name,
                            const std::vector<Axis>& axes) {
  const Eigen::MatrixXd matrix = allocation(axes);
  std::string text = fmt::format(
      "/// Allocation of '{}': force of each of its {} (rows) for a wrench fx fy fz [N] mx my mz [Nm] in the base "
      "frame.\n",
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

std::vector<Constant> make_constants(const Plan& plan) {
  std::vector<Constant> constants;
  for (std::size_t owner : plan.forest.order) {
    const Device& device = plan.robot.devices[owner];
    for (const GeometrySpec& spec : device.type->geometry) {
      if (spec.kind != "allocation") continue;  // the descriptor's schema allows no other
      const std::vector<Axis> axes = actuator_axes(plan, owner, spec.role);
      if (axes.empty()) continue;
      const std::string name = device.name.cpp + "_" + spec.kind;
      constants.push_back({owner, name, allocation_text(plan, owner, spec, name, axes), false});
    }
  }
  return constants;
}

}  // namespace finemote::gen
