// A geometry entry and its joints to why they do not fit.
#pragma once

#include <optional>

#include "generator/descriptor/device_type.hpp"
#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// One geometry entry of one device, with what it is computed of.
struct Placement {
  const Mechanism& mechanism;
  const GeometrySpec& geometry;
  std::string link;                       ///< geometry_link()
  std::vector<std::string> joints;        ///< of the role's children, in their order; all exist
  std::string behind;                     ///< joint of the role `behind`; empty: none
  double radius = 0;                      ///< `rolling`: of a wheel [m]; 0: not known
  std::vector<std::optional<Axis>> axes;  ///< of the joints, in the frame of the link
};

/// With the axes of its joints.
Placement place(const Mechanism& mechanism, const GeometrySpec& geometry, std::string link,
                std::vector<std::string> joints, std::string behind = {}, double radius = 0);

/// Why each joint cannot be one of them, in itself or beside those before it; empty: it can. For kinds of joints.
std::vector<std::string> joint_problems(const Placement& placement);

/// Why joints that are right one by one do not do together; empty: they do.
std::string joints_problem(const Placement& placement);

/// What kind of URDF joint turns: revolute or continuous.
bool turns(const Joint& joint);

}  // namespace finemote::gen
