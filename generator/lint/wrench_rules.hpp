// Rules about actuators that push a body: the forces and torques they yield together.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3158: axes of the wrench the device commands that its actuators do not produce within the tolerance.
void find_missing_axes(const CheckedGeometry& checked, Findings& findings);
/// FM3159: axes that they produce only with many times the force.
void find_weak_axes(const CheckedGeometry& checked, Findings& findings);
/// FM3167
void find_doubled_axes(const CheckedGeometry& checked, Findings& findings);

}  // namespace finemote::gen
