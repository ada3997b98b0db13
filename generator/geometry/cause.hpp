// An axis of the wrench that is hardly produced to what of the thrusters produces it: axes, or origins, that hardly
// differ.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/geometry/allocation.hpp"

namespace finemote::gen {

/// Whether actuators whose axes differ by no more than the tolerance, made parallel, do not produce the axis any more.
bool comes_from_axes(const std::vector<Axis>& actuators, std::size_t axis, double tolerance);

/// A coordinate in which the actuators' origins differ little, and without which they do not produce the axis any more.
struct NearOrigins {
  char coordinate = 0;  ///< `x`, `y` or `z`; 0: none
  double apart = 0;     ///< how far at most [m]
};
NearOrigins near_origins(const std::vector<Axis>& actuators, std::size_t axis, double tolerance);

}  // namespace finemote::gen
