// Rules about sensors whose data depend on the link they are on.
#pragma once

#include "generator/lint/rule.hpp"

namespace finemote::gen {

/// FM3163: one that a driven joint turns against the body whose motion it is to measure, and one that is not carried by
/// the joints it is to measure.
void find_misplaced_sensors(const CheckedGeometry& checked, Findings& findings);

}  // namespace finemote::gen
