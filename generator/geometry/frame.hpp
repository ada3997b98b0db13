// A geometry entry to the link in whose frame its numbers are.
#pragma once

#include "generator/descriptor/device_type.hpp"
#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// The link that most of these joints hang on: most often their parent. Where several links carry as many, the nearest
/// that carries all of those links. Empty without joints, or where a chain of joints does not end.
std::string carrier(const Mechanism& mechanism, const std::vector<std::string>& joints);

/// The link whose frame the constants of one of a device's geometry entries are in, with every joint at zero.
///
/// The device's `link`, `device_link`; where it is empty, carrier() of what pushes or rolls (`allocation`, `rolling`),
/// Mechanism::body() of what asks what is ahead (`axes`, `range` of a role), and Mechanism::base() of what asks only
/// where up is (`chain`). Empty for kinds without a frame (`range` of the device itself), for `mount`, which has
/// mount_link(), and where carrier() is.
std::string geometry_link(const Mechanism& mechanism, const std::string& device_link, const GeometrySpec& geometry,
                          const std::vector<std::string>& joints);

/// Why a wrench about this link, or rolling of it, says nothing of the robot; empty: it does. The world does not move,
/// and what a joint of these turns moves against the rest.
std::string body_problem(const Mechanism& mechanism, const std::string& link, const std::vector<std::string>& joints);

/// `allocation` and `rolling`: the constants are about a body.
bool is_about_body(const GeometrySpec& geometry);

}  // namespace finemote::gen
