// Floor division by one divisor, many times: a multiplication and a correction instead of a 64-bit division.
#pragma once

#include <cstdint>

#include "generator/units/checked.hpp"

namespace finemote::gen {

/// Divides any number by one divisor > 0; exact, like floor_div.
class Divider {
 public:
  explicit Divider(std::int64_t divisor = 1) : divisor_(divisor), inverse_(1.0 / static_cast<double>(divisor)) {}

  [[nodiscard]] std::int64_t floor(std::int64_t a) const {
    const double estimate = static_cast<double>(a) * inverse_;
    const bool is_large = estimate > kExact || estimate < -kExact || a > kFar || a < -kFar;
    if (is_large) return floor_div(a, divisor_);
    // Off by one at most: both roundings together stay far below one.
    auto quotient = static_cast<std::int64_t>(estimate);
    const std::int64_t rest = a - quotient * divisor_;
    if (rest < 0) --quotient;
    if (rest >= divisor_) ++quotient;
    return quotient;
  }

  /// a less its largest multiple below: in [0, divisor).
  [[nodiscard]] std::int64_t rest(std::int64_t a) const { return a - floor(a) * divisor_; }

 private:
  static constexpr double kExact = 1e15;
  static constexpr std::int64_t kFar = std::int64_t{1} << 62;  ///< beyond, a quotient too large by one would overflow
  std::int64_t divisor_;
  double inverse_;
};

}  // namespace finemote::gen
