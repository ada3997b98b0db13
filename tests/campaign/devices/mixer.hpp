// Joins devices and gives each of its actuators another command in every run, so that every output can be watched.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"
#include "finemote/interfaces/light.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/servo.hpp"
#include "finemote/interfaces/sounder.hpp"
#include "finemote/interfaces/thruster.hpp"
#include "gauge.hpp"

namespace campaign {

/// Its state is as old as the oldest valid one below it.
class Mixer {
 public:
  constexpr Mixer(finemote::Ports<finemote::Any> inputs, finemote::Ports<finemote::Motor> motors,
                  finemote::Ports<finemote::Servo> servos, finemote::Ports<finemote::Thruster> thrusters,
                  finemote::Ports<finemote::Light> lights, finemote::Ports<finemote::Sounder> sounders,
                  finemote::Ports<Level> gauges)
      : inputs_(inputs),
        motors_(motors),
        servos_(servos),
        thrusters_(thrusters),
        lights_(lights),
        sounders_(sounders),
        gauges_(gauges) {}

  void update() {
    state = {finemote::now(), true};
    include(inputs_);
    include(motors_);
    include(servos_);
    include(thrusters_);
    include(lights_);
    include(sounders_);
    include(gauges_);
  }

  void handle() {
    step_ = step_ == kSteps ? 1 : step_ + 1;
    const float share = static_cast<float>(step_) / kSteps;
    for (const auto& input : inputs_) input.command = state;
    for (const auto& motor : motors_) {
      stamp(motor.command);
      motor.command.torque = kMostTorque * (2 * share - 1);
    }
    for (const auto& servo : servos_) {
      stamp(servo.command);
      servo.command.angle = share;
    }
    for (const auto& thruster : thrusters_) {
      stamp(thruster.command);
      thruster.command.effort = share;
    }
    for (const auto& light : lights_) {
      stamp(light.command);
      light.command.red = light.command.green = light.command.blue = share;
    }
    for (const auto& sounder : sounders_) {
      stamp(sounder.command);
      sounder.command.frequency = kTone * (1 + share);
    }
    for (const auto& gauge : gauges_) {
      stamp(gauge.command);
      gauge.command.opening = step_;
    }
  }

  finemote::Stamp state;
  finemote::Stamp command;

 private:
  static constexpr std::uint8_t kSteps = 97;   ///< commands until they repeat
  static constexpr float kMostTorque = 0.02F;  ///< N m
  static constexpr float kTone = 1000;         ///< Hz, half of the highest

  template <class Ports>
  void include(const Ports& ports) {
    for (const auto& port : ports) {
      if (port.state.valid && port.state.origin < state.origin) state.origin = port.state.origin;
    }
  }
  void stamp(finemote::Stamp& to) const { to = state; }

  const finemote::Ports<finemote::Any> inputs_;
  const finemote::Ports<finemote::Motor> motors_;
  const finemote::Ports<finemote::Servo> servos_;
  const finemote::Ports<finemote::Thruster> thrusters_;
  const finemote::Ports<finemote::Light> lights_;
  const finemote::Ports<finemote::Sounder> sounders_;
  const finemote::Ports<Level> gauges_;
  std::uint8_t step_ = 0;
};

}  // namespace campaign
