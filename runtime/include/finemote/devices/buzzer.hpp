// Turns a tone into a square wave on a timer of its own.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/sounder.hpp"
#include "finemote/pwm.hpp"

namespace finemote {

/// A buzzer without an oscillator of its own. Loudness is the share of time it is on, at most half. Silent without
/// fresh data. Its output has to be alone on its timer: the pitch is the timer's period.
class Buzzer {
 public:
  static constexpr float kLowest = 20, kHighest = 20000;  ///< Hz; beyond them it is silent

  struct Config {
    float volume = 1;                       ///< of the loudest tone, 0..1
    Duration max_age = 200 * kMillisecond;  ///< of the command's origin
  };

  constexpr Buzzer(const Config& config, PwmChannel channel) : config_(config), channel_(channel) {}

  void update();
  void handle();
  /// Silent at the next flush. May interrupt update() and handle().
  void safe();

  SounderState state;
  SounderCommand command;

 private:
  const Config config_;
  PwmChannel channel_;
  float frequency_ = 0;
};

}  // namespace finemote
