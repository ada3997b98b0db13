// Links and joints to poses: where everything is with every joint at zero.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "generator/urdf/kinematics.hpp"

namespace finemote::gen {

/// The URDF's tree; lengths in m, angles in rad. Holds no copy.
class Mechanism {
 public:
  Mechanism(const std::vector<Link>& links, const std::vector<Joint>& joints) : links_(links), joints_(joints) {}

  [[nodiscard]] const std::vector<Link>& links() const { return links_; }
  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] const Link* link(const std::string& name) const;
  [[nodiscard]] const Joint* joint(const std::string& name) const;
  /// The joint that carries a link; null for the root link.
  [[nodiscard]] const Joint* joint_to(const std::string& link) const;
  /// The first link that no joint carries; empty in a robot without links.
  [[nodiscard]] std::string root() const;
  /// The link the robot stands on or moves with: the root, or, where the root is the world it moves in, the link that a
  /// floating or planar joint of the root carries, and so on where that is a world again (`map`, `odom`). A link is a
  /// world by its name, or if it has no mass and that joint alone.
  [[nodiscard]] std::string base() const;
  /// The link that says what is ahead: base(), or, where that is a world the robot is fixed to or a `base_footprint`
  /// below it, the link that a fixed joint carries upright, if everything that moves is behind that joint.
  [[nodiscard]] std::string body() const;

  /// Joints from the root link to a link; none when the chain does not end.
  [[nodiscard]] std::optional<std::vector<const Joint*>> way_to(const std::string& link) const;
  /// Takes coordinates of the link's frame to those of the link `of`; none when a chain does not end. Only joints
  /// between the two count: where the robot stands in its world changes no digit.
  [[nodiscard]] std::optional<Eigen::Isometry3d> pose(const std::string& link, const std::string& of) const;

 private:
  [[nodiscard]] bool is_world(const std::string& name) const;
  [[nodiscard]] const Joint* joint_in_world(const std::string& world) const;
  [[nodiscard]] const Joint* joint_of_all_motion(const std::string& link) const;

  const std::vector<Link>& links_;
  const std::vector<Joint>& joints_;
};

/// `world`, `map`, `odom`, `earth`.
bool is_world_name(const std::string& link);

/// Fixed-axis roll, pitch, yaw as URDF defines them.
Eigen::Isometry3d transform(const Pose& pose);

/// A place and a direction in the frame of a link.
struct Axis {
  Eigen::Vector3d point;      ///< [m]
  Eigen::Vector3d direction;  ///< unit length
};

/// Where the joint named `joint` is and which way its axis points, in the frame of the link `of`. None when the joint
/// does not exist, has no axis, or its chain does not end.
std::optional<Axis> joint_axis(const Mechanism& mechanism, const std::string& joint, const std::string& of);

}  // namespace finemote::gen
