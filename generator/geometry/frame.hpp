// A device's geometry to the link in whose frame its numbers are.
#pragma once

#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

/// The link that most of these joints hang on: most often their parent. Where several links carry as many, the nearest
/// that carries all of those links. Empty without joints, or where a chain of joints does not end.
std::string carrier(const Mechanism& mechanism, const std::vector<std::string>& joints);

/// The link whose frame the constants of one of a device's geometry entries are in, with every joint at zero.
///
/// What pushes or rolls (`allocation`, `rolling`) does so about the body: the device's `link`, else carrier(). What
/// asks where up is (`chain`, `axes`) is in the axes the robot stands in: the device's `link`, else Mechanism::base();
/// `mount`, whose `link` is the part's own, always in those of the base. Empty for kinds that have no frame, and where
/// carrier() is.
std::string geometry_link(const Mechanism& mechanism, const Device& device, const GeometrySpec& geometry,
                          const std::vector<std::string>& joints);

/// Why a wrench about this link, or rolling of it, says nothing of the robot; empty: it does. The world does not move,
/// and what a joint of these turns moves against the rest.
std::string body_problem(const Mechanism& mechanism, const std::string& link, const std::vector<std::string>& joints);

/// `allocation` and `rolling`: the constants are about a body.
bool is_about_body(const GeometrySpec& geometry);

}  // namespace finemote::gen
