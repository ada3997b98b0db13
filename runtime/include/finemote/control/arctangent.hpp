// Angles of points and of sines, in a time that hardly depends on them.
#pragma once

namespace finemote {

/// Angle of the point (x, y) from the x axis on, in [-pi, pi]: within 5e-7 where both are finite and their absolute
/// values add up to a finite number; 0 for the origin, pi on the whole negative half of the axis. Context: any bucket.
float arctangent(float y, float x);
/// Angle in [-pi/2, pi/2] of a sine: within 5e-7 for -1..1; what is beyond it counts as the nearer end. Context: any
/// bucket.
float arcsine(float sine);

}  // namespace finemote
