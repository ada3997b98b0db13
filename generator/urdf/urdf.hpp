// XML to links and joints: what later stages need of the URDF itself, checked by us for place and by urdfdom for sense.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/urdf/kinematics.hpp"
#include "generator/xml/node.hpp"

namespace finemote::gen {

/// A word of a link or joint that ROS tools skip silently, and its writer most likely meant to count.
struct Doubt {
  std::string joint;        ///< whose it is; empty: the link's
  std::string link;         ///< whose it is; empty: the joint's
  bool is_missing = false;  ///< something else counts in its place: what is computed from it may be wrong
  Diagnostic finding;       ///< a warning
};

/// Links and joints in document order.
struct Kinematics {
  std::vector<Link> links;
  std::vector<Joint> joints;

  std::vector<Doubt> doubts;                        ///< in document order
  std::set<std::string, std::less<>> wrong_links;   ///< with mistakes that were reported: what they hold is not known
  std::set<std::string, std::less<>> wrong_joints;  ///< the same
  std::set<std::string, std::less<>> default_axes;  ///< joints whose axis the file does not give

  [[nodiscard]] const Link* link(std::string_view name) const;
  [[nodiscard]] const Joint* joint(std::string_view name) const;
};

/// Reads the `<link>` and `<joint>` elements of a `<robot>`.
///
/// Lengths in m, angles in rad, whatever the locale. Reports FM2002 (a joint names a link that does not exist), FM2007
/// (a name used twice), FM2008 (malformed numbers), FM2009 (unknown joint type), FM2010 (a link with two parents),
/// FM2012 (a number nothing has), FM3010 (a missing name, type, parent or child) and, when all that is right, FM2001
/// with urdfdom's own words. A robot without links is accepted: it has firmware only.
Kinematics read_urdf(const xml::Node& robot, Diagnostics& diagnostics);

}  // namespace finemote::gen
