// Turns an angle into the pulse width of a servo.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/geometry.hpp"
#include "finemote/interfaces/servo.hpp"
#include "finemote/pwm.hpp"

namespace finemote {

/// Angle 0 is the middle between `min` and `max`; `travel` is the angle between them. Angles beyond it, or beyond the
/// limits of the joint, are cut. What happens without fresh data is a choice: stay, go to the middle (or as near as the
/// joint may turn), or fall limp (no pulse).
class PwmServo {
 public:
  enum class OnLoss : std::uint8_t { kHold, kCentre, kRelease };

  struct Config {
    Duration min = 500 * kMicrosecond;      ///< pulse at -travel / 2
    Duration max = 2500 * kMicrosecond;     ///< pulse at +travel / 2
    float travel = 3.14159265F;             ///< rad
    bool reverse = false;                   ///< the other way round
    Duration max_age = 500 * kMillisecond;  ///< of the command's origin
    OnLoss on_loss = OnLoss::kHold;
  };

  /// @param range  of the joint; null: the whole travel
  constexpr PwmServo(const Config& config, const JointRange* range, PwmChannel channel)
      : config_(config),
        lowest_(range != nullptr && range->lower > -config.travel / 2 ? range->lower : -config.travel / 2),
        highest_(range != nullptr && range->upper < config.travel / 2 ? range->upper : config.travel / 2),
        channel_(channel) {}
  constexpr PwmServo(const Config& config, PwmChannel channel) : PwmServo(config, nullptr, channel) {}

  void update();
  void handle();
  /// As on loss of data, at the next flush. May interrupt update() and handle().
  void safe();

  ServoState state;
  ServoCommand command;

  /// Pulse width [ns] for an angle [rad].
  [[nodiscard]] std::uint32_t pulse(float angle) const;

 private:
  const Config config_;
  const float lowest_, highest_;  ///< rad
  PwmChannel channel_;
  float angle_ = 0;
};

}  // namespace finemote
