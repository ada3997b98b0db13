// Joint poses to matrices: where actuators push, and how to push together.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// A place and a direction in the base frame: the root link of the URDF.
struct Axis {
  Eigen::Vector3d point;      ///< [m]
  Eigen::Vector3d direction;  ///< unit length
};

/// Where the joint named `joint` is and which way its axis points, with every joint from the root link to it at zero.
/// None when the joint does not exist or its chain does not end.
std::optional<Axis> joint_axis(const Robot& robot, const std::string& joint);

/// Thruster allocation: column n of the wrench matrix is (direction; point x direction) of actuator n; the result is
/// its Moore-Penrose pseudo-inverse, one row of six per actuator, so that forces = result * (fx fy fz mx my mz). Forces
/// in N for wrenches in N and Nm. Singular directions (below 1e-9 of the largest) get no force.
Eigen::MatrixXd allocation(const std::vector<Axis>& actuators);

}  // namespace finemote::gen
