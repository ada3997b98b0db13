// The mechanics of a robot as its URDF describes them: links, joints and where they are.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

struct Pose {
  std::array<double, 3> xyz{};  ///< [m]
  std::array<double, 3> rpy{};  ///< [rad]
};

/// A joint of the URDF, as urdfdom accepted it.
struct Joint {
  std::string name;
  std::string type;  ///< revolute, continuous, prismatic, fixed, floating, planar
  std::string parent_link, child_link;
  Pose origin;
  std::array<double, 3> axis{1, 0, 0};
  std::optional<double> lower, upper, effort, velocity;
  std::optional<double> damping, friction;
  std::string mimic;  ///< the joint whose angle it takes over; empty: it moves by itself
  Position at;
};

/// Mass of a link and how it is spread.
struct Inertial {
  Pose origin;                      ///< centre of mass and axes of `inertia`, in the link's frame
  double mass = 0;                  ///< [kg]
  std::array<double, 6> inertia{};  ///< xx xy xz yy yz zz [kg m^2]
};

struct Link {
  std::string name;
  Position at;
  std::optional<Inertial> inertial;
};

}  // namespace finemote::gen
