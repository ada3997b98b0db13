#include "finemote/control/arctangent.hpp"

#include <cmath>

#include "finemote/control/numbers.hpp"

namespace finemote {
namespace {

constexpr float kPi = 3.14159265F, kQuarterTurn = 0.5F * kPi, kEighthTurn = 0.25F * kPi;
constexpr float kTangentOfSixteenth = 0.41421356F;  ///< of pi/8

/// For -tan(pi/8)..tan(pi/8): the odd polynomial of degree 9 with 1 as its first coefficient whose largest error there
/// is least, 4.9e-9 before rounding (found by Remez' exchange).
float of_small(float t) {
  const float square = t * t;
  float sum = 0.0790259837F;
  sum = sum * square - 0.138244538F;
  sum = sum * square + 0.199718793F;
  sum = sum * square - 0.333327567F;
  return t + t * square * sum;
}

/// Of the smaller one of two numbers >= 0 over the larger one: 0..pi/4. The tangent of a difference brings angles above
/// pi/8 down to below it.
float of_octant(float smaller, float larger) {
  const bool far = smaller > larger * kTangentOfSixteenth;
  const float tangent = far ? (smaller - larger) / (smaller + larger) : smaller / larger;
  return (far ? kEighthTurn : 0) + of_small(tangent);
}

}  // namespace

float arctangent(float y, float x) {
  const float height = std::fabs(y), width = std::fabs(x);
  if (height == 0 && width == 0) return 0;
  const bool steep = height > width;
  const float octant = steep ? of_octant(width, height) : of_octant(height, width);
  const float quadrant = steep ? kQuarterTurn - octant : octant;
  const float angle = x < 0 ? kPi - quadrant : quadrant;
  return y < 0 ? -angle : angle;
}

float arcsine(float sine) {
  const float within = clamp(sine, -1, 1);
  return arctangent(within, __builtin_sqrtf((1 - within) * (1 + within)));
}

}  // namespace finemote
