#include "generator/emit/geometry.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>

namespace finemote::gen {
namespace {

/// Fixed-axis roll, pitch, yaw as URDF defines them.
Eigen::Isometry3d transform(const Pose& pose) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.translate(Eigen::Vector3d(pose.xyz[0], pose.xyz[1], pose.xyz[2]));
  t.rotate(Eigen::AngleAxisd(pose.rpy[2], Eigen::Vector3d::UnitZ()));
  t.rotate(Eigen::AngleAxisd(pose.rpy[1], Eigen::Vector3d::UnitY()));
  t.rotate(Eigen::AngleAxisd(pose.rpy[0], Eigen::Vector3d::UnitX()));
  return t;
}

const Joint* joint_where(const Robot& robot, const std::string Joint::*field, const std::string& value) {
  const auto found =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) { return joint.*field == value; });
  return found == robot.joints.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Axis> joint_axis(const Robot& robot, const std::string& name) {
  const Joint* joint = joint_where(robot, &Joint::name, name);
  if (joint == nullptr) return std::nullopt;
  const Eigen::Vector3d axis(joint->axis[0], joint->axis[1], joint->axis[2]);
  if (axis.norm() == 0) return std::nullopt;
  Eigen::Isometry3d to_base = Eigen::Isometry3d::Identity();
  std::size_t steps = 0;
  for (const Joint* up = joint; up != nullptr; up = joint_where(robot, &Joint::child_link, up->parent_link)) {
    if (++steps > robot.joints.size()) return std::nullopt;
    to_base = transform(up->origin) * to_base;
  }
  return Axis{to_base.translation(), to_base.linear() * axis.normalized()};
}

Eigen::MatrixXd allocation(const std::vector<Axis>& actuators) {
  Eigen::MatrixXd wrench(6, static_cast<Eigen::Index>(actuators.size()));
  for (std::size_t n = 0; n < actuators.size(); ++n) {
    const auto column = static_cast<Eigen::Index>(n);
    wrench.block<3, 1>(0, column) = actuators[n].direction;
    wrench.block<3, 1>(3, column) = actuators[n].point.cross(actuators[n].direction);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(wrench, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Eigen::VectorXd inverse = svd.singularValues();
  const double smallest = 1e-9 * (inverse.size() > 0 ? inverse[0] : 0);
  for (double& value : inverse) value = value > smallest ? 1 / value : 0;
  return svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
}

}  // namespace finemote::gen
