// Links, joints and devices of a robot to where they are: what a picture of its body is drawn from.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen::report {

/// All points are in the frame of the link `base` [m]: x ahead, y left, z up; every joint at zero.
struct Body {
  struct Bone {
    Eigen::Vector3d from, to;  ///< origins of the links that a joint connects
  };
  struct Part {
    std::string device, at;  ///< `joint 'thruster_1_joint'`, `link 'imu_link'`
    Eigen::Vector3d point;
    std::optional<Eigen::Vector3d> axis;  ///< of its joint, unit length
    bool pushes = false;                  ///< its joint is one of an allocation: the axis is the way it pushes
  };
  /// How hard the parts that push can push together along x, y and z, if each makes 1 N [N].
  Eigen::Vector3d authority = Eigen::Vector3d::Zero();
  std::string base;
  std::vector<Bone> bones;
  std::vector<Part> parts;  ///< of the devices that name a link or a joint, in document order
};

Body body_of(const Robot& robot);

/// The body from above, from the right and from behind, as three pictures of one scale, and a table of what the numbers
/// in them stand for. Empty where no device names a link or a joint.
std::string body_pictures(const Body& body);

}  // namespace finemote::gen::report
