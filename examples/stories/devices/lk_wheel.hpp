// Turns torque into a word of the frame that commands four LK motors at once, and a motor's reply into a state.
#pragma once

#include <cmath>
#include <cstdint>

#include "finemote/can.hpp"
#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/interfaces/motor.hpp"

namespace stories {

/// Every motor answers the common frame with one of its own: command, temperature, current, speed [deg/s], encoder, the
/// last three of them 16 bits with the low byte first. The current of a command is in the same unit.
class LkWheel {
 public:
  struct Config {
    float torque_per_word = 0.0017F;  ///< N m
    finemote::Duration max_age = 100 * finemote::kMillisecond;
  };
  constexpr LkWheel(const Config& config, finemote::CanSlot& slot) : config_(config), slot_(&slot) {}

  void update() {
    const finemote::CanSlot::Received received = slot_->received();
    if (received.count != seen_ && received.frame.size == 8) take(received);
    seen_ = received.count;
    if (!finemote::is_fresh(state, finemote::now(), kReplyMaxAge)) state.valid = false;
    state.unreachable = !state.valid || slot_->bus().unreachable();
  }

  void handle() {
    const bool usable = finemote::is_fresh(command, finemote::now(), config_.max_age) && std::isfinite(command.torque);
    drive(usable ? command.torque : 0);
  }

  void safe() { drive(0); }

  finemote::MotorState state;
  finemote::MotorCommand command;

 private:
  static constexpr finemote::Duration kReplyMaxAge = 20 * finemote::kMillisecond;
  static constexpr float kMostWord = 2000, kDegree = 0.01745329252F, kStep = 6.28318530718F / 65536;

  static std::int16_t word_at(const finemote::CanFrame& frame, unsigned at) {
    return static_cast<std::int16_t>(frame.data[at] | frame.data[at + 1] << 8);
  }

  void take(const finemote::CanSlot::Received& received) {
    state.temperature = received.frame.data[1];
    state.torque = static_cast<float>(word_at(received.frame, 2)) * config_.torque_per_word;
    state.speed = static_cast<float>(word_at(received.frame, 4)) * kDegree;
    state.angle = static_cast<float>(static_cast<std::uint16_t>(word_at(received.frame, 6))) * kStep;
    state.origin = received.at;
    state.valid = true;
  }

  void drive(float torque) {
    const float word = finemote::clamp(torque / config_.torque_per_word, -kMostWord, kMostWord);
    const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(word));
    const std::uint8_t bytes[]{static_cast<std::uint8_t>(bits & 0xFF), static_cast<std::uint8_t>(bits >> 8)};
    static_cast<void>(slot_->set_shared(bytes));
  }

  const Config config_;
  finemote::CanSlot* const slot_;
  std::uint32_t seen_ = 0;
};

}  // namespace stories
