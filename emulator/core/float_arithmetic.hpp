// Single-precision arithmetic of the FPv4-SP unit on the host's own: ARMv7-M Architecture Reference Manual A2.7.
//
// Rounding to nearest, subnormal numbers kept, no default NaN, as FPSCR is after reset. The host computes the same
// bits (IEEE 754), but for the NaN of an invalid operation and the choice among two of them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace finemote::emulator {

constexpr std::uint32_t kFloatSign = 0x80000000U, kQuietBit = 0x00400000U, kDefaultNan = 0x7FC00000U;

constexpr float as_float(std::uint32_t bits) { return std::bit_cast<float>(bits); }
constexpr std::uint32_t as_bits(float value) { return std::bit_cast<std::uint32_t>(value); }
constexpr bool is_nan(std::uint32_t bits) { return (bits & ~kFloatSign) > 0x7F800000U; }
constexpr bool is_signalling(std::uint32_t bits) { return is_nan(bits) && (bits & kQuietBit) == 0; }

/// FPProcessNaNs: signalling ones first, then in the order of the operands; the default one where there is none.
constexpr std::uint32_t nan_of(std::uint32_t a, std::uint32_t b) {
  if (is_signalling(a)) return a | kQuietBit;
  if (is_signalling(b)) return b | kQuietBit;
  if (is_nan(a)) return a;
  return is_nan(b) ? b : kDefaultNan;
}

inline std::uint32_t finished(float result, std::uint32_t a, std::uint32_t b) {
  return result == result ? as_bits(result) : nan_of(a, b);
}

inline std::uint32_t float_add(std::uint32_t a, std::uint32_t b) { return finished(as_float(a) + as_float(b), a, b); }
inline std::uint32_t float_subtract(std::uint32_t a, std::uint32_t b) {
  return finished(as_float(a) - as_float(b), a, b);
}
inline std::uint32_t float_multiply(std::uint32_t a, std::uint32_t b) {
  return finished(as_float(a) * as_float(b), a, b);
}
inline std::uint32_t float_divide(std::uint32_t a, std::uint32_t b) {
  return finished(as_float(a) / as_float(b), a, b);
}
inline std::uint32_t float_root(std::uint32_t a) { return finished(std::sqrt(as_float(a)), a, a); }

/// FPMulAdd: addend + a * b, rounded once.
inline std::uint32_t float_fused(std::uint32_t addend, std::uint32_t a, std::uint32_t b) {
  const float result = std::fma(as_float(a), as_float(b), as_float(addend));
  if (result == result) return as_bits(result);
  const auto is_infinite = [](std::uint32_t x) { return (x & ~kFloatSign) == 0x7F800000U; };
  const auto is_zero = [](std::uint32_t x) { return (x & ~kFloatSign) == 0; };
  const bool invalid = (is_infinite(a) && is_zero(b)) || (is_zero(a) && is_infinite(b));
  if (is_signalling(addend)) return addend | kQuietBit;
  if (is_nan(addend)) {
    if (invalid) return kDefaultNan;
    if (!is_signalling(a) && !is_signalling(b)) return addend;
  }
  return nan_of(a, b);
}

/// FPToFixed with saturation; a NaN becomes 0. @param towards_zero  else to nearest, ties to even
inline std::uint32_t float_to_integer(double value, bool is_signed, unsigned width, bool towards_zero) {
  if (value != value) return 0;
  const double whole = towards_zero ? std::trunc(value) : std::nearbyint(value);
  const double high = std::ldexp(1.0, static_cast<int>(is_signed ? width - 1 : width)) - 1,
               low = is_signed ? -high - 1 : 0;
  const double kept = whole < low ? low : whole > high ? high : whole;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(kept));
}

/// A half-precision number, IEEE format.
inline std::uint32_t half_to_float(std::uint32_t half) {
  const std::uint32_t sign = (half & 0x8000) << 16, exponent = half >> 10 & 0x1F, fraction = half & 0x3FF;
  if (exponent == 31) return sign | 0x7F800000U | fraction << 13 | (fraction != 0 ? kQuietBit : 0);
  const float value = exponent == 0 ? std::ldexp(static_cast<float>(fraction), -24)
                                    : std::ldexp(static_cast<float>(fraction | 0x400), static_cast<int>(exponent) - 25);
  return sign | as_bits(value);
}

inline std::uint32_t float_to_half(std::uint32_t bits) {
  const std::uint32_t sign = bits >> 16 & 0x8000;
  if (is_nan(bits)) return sign | 0x7E00 | (bits >> 13 & 0x1FF);
  const double value = std::fabs(as_float(bits));
  if (value == 0) return sign;
  if (value >= 65520.0) return sign | 0x7C00;
  int exponent = 0;
  static_cast<void>(std::frexp(value, &exponent));
  const int scale = exponent < -13 ? 24 : 11 - exponent;  // so that the last bit of the half counts one
  const auto steps = static_cast<std::uint32_t>(std::nearbyint(std::ldexp(value, scale)));
  // The steps of a normal number carry its hidden bit, which adds one to the exponent.
  return sign | (exponent < -13 ? steps : (static_cast<std::uint32_t>(exponent + 13) << 10) + steps);
}

}  // namespace finemote::emulator
