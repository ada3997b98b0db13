// A joint's limits and the travel of what drives it to how far the joint may turn.
#pragma once

#include <optional>
#include <vector>

#include "generator/descriptor/device_type.hpp"
#include "generator/geometry/mechanism.hpp"

namespace finemote::gen {

struct Range {
  double lower = 0, upper = 0;  ///< [rad]; there is none where lower >= upper
};

/// Of a revolute joint; a limit that is not written is 0, as URDF says. None: it turns without end.
std::optional<Range> limits_of(const Joint& joint);

/// What of a range is within half a travel to either side of 0.
Range within_travel(const Range& range, double travel);

/// The limits of a role's joint, about the entry's `along` or else the joint's own axis, with the device's `link`: a
/// joint that turns the other way round has them the other way round. None: it has no limits.
std::optional<Range> limits_along(const Mechanism& mechanism, const std::string& device_link,
                                  const GeometrySpec& geometry, const std::string& joint);

/// Of the device's params `lowest` and `highest`; all angles where the entry names none.
Range allowed_range(const std::vector<Param>& params, const GeometrySpec& geometry);

/// What of both.
Range common(const Range& one, const Range& other);

/// How far each joint of a role may turn: limits_along() within allowed_range(). Empty where no joint has limits: then
/// only the params count.
std::vector<Range> role_ranges(const Mechanism& mechanism, const std::string& device_link,
                               const std::vector<Param>& params, const GeometrySpec& geometry,
                               const std::vector<std::string>& joints);

/// The value of the param that the entry names [its unit]; 0 where it names none.
double geometry_param(const std::vector<Param>& params, const GeometrySpec& geometry);

}  // namespace finemote::gen
