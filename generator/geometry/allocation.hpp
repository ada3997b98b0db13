// Thrusters to their allocation: how to push together, and what they cannot.
#pragma once

#include <array>

#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// A wrench in this order: forces [N] along the axes of a link, moments [Nm] about them through its origin.
inline constexpr std::array<const char*, 6> kWrenchAxes{"fx", "fy", "fz", "mx", "my", "mz"};

/// Column n: (direction; point x direction) of actuator n, the wrench of 1 N from it.
Eigen::MatrixXd wrench_matrix(const std::vector<Axis>& actuators);

/// Thruster allocation: the Moore-Penrose pseudo-inverse of the wrench matrix, one row of six per actuator, so that
/// forces = result * (fx fy fz mx my mz). Forces in N for wrenches in N and Nm. Singular directions (below 1e-9 of the
/// largest) get no force.
Eigen::MatrixXd allocation(const std::vector<Axis>& actuators);

/// What becomes of a unit command on one axis of the wrench.
struct AxisYield {
  double fraction = 0;  ///< of it that the actuators produce, 0..1: the diagonal of A * pinv(A)
  /// How many times the command's force the hardest pushing actuator needs; a moment counts as the force at the arm of
  /// the actuator furthest from the middle of all.
  double effort = 0;
};
/// In the order of kWrenchAxes.
std::array<AxisYield, 6> axis_yields(const std::vector<Axis>& actuators);

/// Moore-Penrose pseudo-inverse; singular values below 1e-9 of the largest count as zero.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

/// Largest first.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

}  // namespace finemote::gen
