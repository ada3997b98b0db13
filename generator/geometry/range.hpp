// A joint's limits and the travel of what drives it to how far the joint may turn.
#pragma once

#include <optional>

#include "generator/model/robot.hpp"

namespace finemote::gen {

struct Range {
  double lower = 0, upper = 0;  ///< [rad]; there is none where lower >= upper
};

/// Of a revolute joint; a limit that is not written is 0, as URDF says. None: it turns without end.
std::optional<Range> limits_of(const Joint& joint);

/// What of a range is within half a travel to either side of 0.
Range within_travel(const Range& range, double travel);

/// The value of the param that the entry names [its unit]; 0 where it names none.
double geometry_param(const Device& device, const GeometrySpec& geometry);

}  // namespace finemote::gen
