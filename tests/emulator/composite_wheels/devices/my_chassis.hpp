// Drives straight on: the same torque at every wheel.
#pragma once

#include "finemote/contract.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/time.hpp"

class MyChassis {
 public:
  struct Config {
    float wheel_radius = 0.076F;
  };
  constexpr MyChassis(const Config& config, finemote::Ports<finemote::Motor> wheels)
      : config_(config), wheels_(wheels) {}

  void update() {
    state = {wheels_[0].state.origin, true};
    for (const auto& wheel : wheels_) state.valid = state.valid && wheel.state.valid;
  }
  void handle() {
    for (const auto& wheel : wheels_) {
      wheel.command.torque = state.valid ? 0.3F : 0;
      wheel.command.origin = state.origin;
      wheel.command.valid = state.valid;
    }
  }

  finemote::Stamp state;

 private:
  Config config_;
  finemote::Ports<finemote::Motor> wheels_;
};
