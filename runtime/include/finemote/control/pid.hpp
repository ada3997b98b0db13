// Turns an error into a bounded correction: proportional, integral with anti-windup, derivative of the measurement.
#pragma once

#include "finemote/control/numbers.hpp"  // which users of this header take from it

namespace finemote {

/// Gains in real units: what they multiply is an error, its integral over seconds, and the measurement's rate per
/// second.
struct PidGains {
  float kp = 0;     ///< output per unit of error
  float ki = 0;     ///< output per unit of error and second
  float kd = 0;     ///< output per unit of the measurement's rate
  float limit = 0;  ///< of the output, both ways; > 0
};

/// output = kp * error + integral - kd * rate, clamped to +-limit.
///
/// The integral is never larger than the limit, and stands still while the output is clamped and the error would drive
/// it further out. So it needs no unwinding, whatever the gains. A step with an error that is not finite does nothing.
class Pid {
 public:
  /// One step; returns the output. Context: bucket.
  /// @param gains  limit > 0
  /// @param error  setpoint less measurement
  /// @param rate  how fast the measurement (not the error) changes, per second
  /// @param dt    time since the last step [s], >= 0
  float step(const PidGains& gains, float error, float rate, float dt);

  void reset() { integral_ = 0; }                             ///< forgets the integral
  [[nodiscard]] float integral() const { return integral_; }  ///< its share of the output

 private:
  float integral_ = 0;
};

}  // namespace finemote
