// Turns a colour into the shares of time that one to three lamps are lit.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/light.hpp"
#include "finemote/pwm.hpp"

namespace finemote {

/// An LED on a pulse output. With the uses `green` and `blue` its own channel is the red one and it shows the colour;
/// without them it shows the brightest of the three. Without fresh data it goes on as it was, dark, or blinks.
class Led {
 public:
  enum class OnLoss : std::uint8_t { kHold, kOff, kBlink };

  struct Config {
    float brightness = 1;                 ///< share of time of a full colour, 0..1
    Duration max_age = 1 * kSecond;       ///< of the command's origin
    OnLoss on_loss = OnLoss::kBlink;      ///< without fresh data
    Duration blink = 500 * kMillisecond;  ///< one on and off
  };

  constexpr Led(const Config& config, PwmChannel own, PwmChannel* green, PwmChannel* blue)
      : config_(config), own_(own), green_(green), blue_(blue) {}

  void update();
  void handle();
  /// Dark, or as on loss where it blinks: then what stops the robot shows. May interrupt update() and handle().
  void safe();

  LightState state;
  LightCommand command;

 private:
  void show(float red, float green, float blue);
  void lose();

  const Config config_;
  PwmChannel own_;
  PwmChannel* const green_;
  PwmChannel* const blue_;
  float shown_[3] = {};
  bool lit_ = false;  ///< of the blinking
  Time turn_at_ = 0;
};

}  // namespace finemote
