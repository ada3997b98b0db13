// 64-bit integer nanoseconds: arithmetic that rounds as mathematics does and never wraps.
#pragma once

#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace finemote::gen::timing {

using Ns = std::int64_t;  ///< nanoseconds, or an exact quantity beside them

/// A sum, product or least common multiple left the range of 64 bits. Thrown in the middle of the formulas and turned
/// into FM4010 where an analysis begins: no formula needs to carry a failure through.
struct Overflow : std::overflow_error {
  using std::overflow_error::overflow_error;
};

/// The analysis would take longer than its budget of steps; becomes FM4011.
struct TooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline Ns add(Ns a, Ns b) {
  Ns sum = 0;
  if (__builtin_add_overflow(a, b, &sum)) throw Overflow("a sum");
  return sum;
}

inline Ns subtract(Ns a, Ns b) {
  Ns difference = 0;
  if (__builtin_sub_overflow(a, b, &difference)) throw Overflow("a difference");
  return difference;
}

inline Ns multiply(Ns a, Ns b) {
  Ns product = 0;
  if (__builtin_mul_overflow(a, b, &product)) throw Overflow("a product");
  return product;
}

/// Floor of a/b for b > 0; rounds to minus infinity, unlike `/`.
constexpr Ns floor_div(Ns a, Ns b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Ceiling of a/b for b > 0.
constexpr Ns ceil_div(Ns a, Ns b) { return a / b + (a % b > 0 ? 1 : 0); }

/// Largest multiple of b that is at most a, for b > 0.
inline Ns round_down(Ns a, Ns b) { return multiply(floor_div(a, b), b); }

/// Smallest multiple of b that is at least a, for b > 0.
inline Ns round_up(Ns a, Ns b) { return multiply(ceil_div(a, b), b); }

/// Least common multiple of positive numbers.
inline Ns lcm(Ns a, Ns b) {
  Ns result = 0;
  if (__builtin_mul_overflow(a / std::gcd(a, b), b, &result))
    throw Overflow("the least common multiple of the periods");
  return result;
}

/// Floor division by one divisor, many times: a multiplication and a correction instead of a 64-bit division.
class Divider {
 public:
  explicit Divider(Ns divisor = 1) : divisor_(divisor), inverse_(1.0 / static_cast<double>(divisor)) {}

  [[nodiscard]] Ns floor(Ns a) const {
    const double estimate = static_cast<double>(a) * inverse_;
    const bool is_large = estimate > kExact || estimate < -kExact || a > kFar || a < -kFar;
    if (is_large) return floor_div(a, divisor_);
    Ns quotient = static_cast<Ns>(estimate);  // off by one at most: both roundings together stay far below one
    const Ns rest = a - quotient * divisor_;
    if (rest < 0) --quotient;
    if (rest >= divisor_) ++quotient;
    return quotient;
  }

  /// a less its largest multiple below: in [0, divisor).
  [[nodiscard]] Ns rest(Ns a) const { return a - floor(a) * divisor_; }

 private:
  static constexpr double kExact = 1e15;
  static constexpr Ns kFar = Ns{1} << 62;  ///< beyond, a quotient too large by one would overflow
  Ns divisor_;
  double inverse_;
};

}  // namespace finemote::gen::timing
