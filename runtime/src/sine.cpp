#include "finemote/control/sine.hpp"

#include "finemote/control/numbers.hpp"

namespace finemote {
namespace {

constexpr float kPi = 3.14159265F, kQuarterTurn = 0.5F * kPi;

/// Its series to the eleventh power: what is left is below the next term, 5.7e-8 at a quarter turn.
float of_quarter(float x) {
  const float square = x * x;
  float sum = -1.0F / 39916800;
  sum = sum * square + 1.0F / 362880;
  sum = sum * square - 1.0F / 5040;
  sum = sum * square + 1.0F / 120;
  sum = sum * square - 1.0F / 6;
  return x + x * square * sum;
}

}  // namespace

float sine(float angle) {
  const float within = wrap_angle(angle);
  if (within > kQuarterTurn) return of_quarter(kPi - within);
  if (within < -kQuarterTurn) return of_quarter(-kPi - within);
  return of_quarter(within);
}

float cosine(float angle) {
  const float within = wrap_angle(angle);
  return of_quarter(kQuarterTurn - (within < 0 ? -within : within));
}

}  // namespace finemote
