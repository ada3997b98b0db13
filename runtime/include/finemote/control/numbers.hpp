// Keeps numbers in bounds: values, angles, time steps.
#pragma once

#include <cstdint>

#include "finemote/time.hpp"

namespace finemote {

/// The value, or the bound it is beyond.
constexpr float clamp(float value, float low, float high) { return value < low ? low : value > high ? high : value; }

/// The same angle in [-pi, pi], in a fixed number of steps; 0 for what is no number or beyond 1e6 rad.
float wrap_angle(float angle);

/// A time step in seconds; anything outside 0..2 s becomes the nearer end. (In 32 bits: a conversion of 64 bits to
/// float costs a library routine.)
constexpr float seconds(Duration step) {
  const Duration bounded = step < 0 ? 0 : step > 2 * kSecond ? 2 * kSecond : step;
  return static_cast<float>(static_cast<std::int32_t>(bounded)) * 1e-9F;
}

}  // namespace finemote
