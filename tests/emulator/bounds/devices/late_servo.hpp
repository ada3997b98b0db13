#pragma once
#include <finemote/contract.hpp>
#include <finemote/interfaces/servo.hpp>
#include <finemote/pwm.hpp>
#include <finemote/time.hpp>

#include <cstdint>

namespace my {

/// The pulse of a command goes out with the job after the one that brought it.
class LateServo {
 public:
  constexpr explicit LateServo(finemote::PwmChannel channel) : channel_(channel) {}

  void update() {
    if (pulse_ != 0) channel_.set(pulse_);
    state = {finemote::now(), true};
  }
  void handle() { pulse_ = kShortest + static_cast<std::uint32_t>(command.angle * kPerRadian); }
  void safe() { channel_.set(0); }

  finemote::ServoState state;
  finemote::ServoCommand command;

 private:
  static constexpr std::uint32_t kShortest = 1000000;  // ns
  static constexpr float kPerRadian = 400000;          // ns
  finemote::PwmChannel channel_;
  std::uint32_t pulse_ = 0;
};

}  // namespace my
