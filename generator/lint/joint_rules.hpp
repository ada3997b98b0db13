// Rules about the joints that a device's constants are computed of, or that it drives.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3160: limits of the device's joint that its travel does not reach.
void find_short_travel(const CheckedGeometry& checked, Findings& findings);
/// FM3164, at the child on the joint.
void find_limited_wheels(const CheckedGeometry& checked, Findings& findings);
/// FM3165: what pushes or rolls is on a joint that something else moves, or such a joint is within a chain.
void find_moved_joints(const CheckedGeometry& checked, Findings& findings);
/// FM3166
void find_massless_chain(const CheckedGeometry& checked, Findings& findings);
/// FM3168
void find_wide_params(const CheckedGeometry& checked, Findings& findings);

}  // namespace finemote::gen
