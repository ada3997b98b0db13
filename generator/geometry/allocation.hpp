// Thrusters to their allocation: how to push together.
#pragma once

#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// Thruster allocation: column n of the wrench matrix is (direction; point x direction) of actuator n; the result is
/// its Moore-Penrose pseudo-inverse, one row of six per actuator, so that forces = result * (fx fy fz mx my mz). Forces
/// in N for wrenches in N and Nm. Singular directions (below 1e-9 of the largest) get no force.
Eigen::MatrixXd allocation(const std::vector<Axis>& actuators);

/// Moore-Penrose pseudo-inverse; singular values below 1e-9 of the largest count as zero.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

}  // namespace finemote::gen
