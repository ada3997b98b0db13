// A heater's share of its power, over time, to the temperature of what it warms: one mass, one way for the heat to
// leave.
#pragma once

#include <cmath>

#include "emulator/time.hpp"

namespace finemote::emulator {

/// Exact between changes: the temperature goes to its rest along an exponential.
class HeatedMass {
 public:
  struct Parameters {
    double ambient = 25;        ///< degrees Celsius
    double rise = 100;          ///< K above ambient it comes to at full power
    double time_constant = 40;  ///< s, above zero
  };

  explicit HeatedMass(const Parameters& parameters) : p_(parameters), celsius_(parameters.ambient) {}

  /// Degrees Celsius. Time does not go back.
  double temperature(Time now) { return advance(now), celsius_; }
  /// The heater has this share of its full power from now on, 0..1.
  void heat(Time now, double share) { advance(now), share_ = share; }
  [[nodiscard]] double share() const { return share_; }
  /// Has this temperature now, and goes on from there.
  void set(Time now, double celsius) { advance(now), celsius_ = celsius; }

 private:
  void advance(Time now) {
    if (now <= at_) return;
    const double seconds = static_cast<double>(now - at_) / (1e9 * kStepsPerNs);
    const double rest = p_.ambient + share_ * p_.rise;
    celsius_ = rest + (celsius_ - rest) * std::exp(-seconds / p_.time_constant);
    at_ = now;
  }

  Parameters p_;
  double celsius_, share_ = 0;
  Time at_ = 0;
};

}  // namespace finemote::emulator
