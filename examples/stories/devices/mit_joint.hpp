// Turns torque into the command frame of a joint motor with the protocol of the MIT Mini Cheetah, and its reply into a
// state.
#pragma once

#include <cmath>
#include <cstdint>

#include "finemote/can.hpp"
#include "finemote/contract.hpp"
#include "finemote/control/pid.hpp"
#include "finemote/interfaces/motor.hpp"

namespace stories {

/// The motor answers every command, and says nothing by itself. Command: position (16 bits), speed, stiffness, damping
/// and torque (12 bits each), of which only the torque is used. Reply, six bytes: id, position (16), speed and torque
/// (12 each).
class MitJoint {
 public:
  struct Config {
    float most_angle = 95.5F, most_speed = 45, most_torque = 18;  ///< ranges of the wire: rad, rad/s, N m
    finemote::Duration max_age = 100 * finemote::kMillisecond;
  };
  constexpr MitJoint(const Config& config, finemote::CanSlot& slot) : config_(config), slot_(&slot) {}

  void update() {
    const finemote::CanSlot::Received received = slot_->received();
    if (received.count != seen_ && received.frame.size == 6) take(received);
    seen_ = received.count;
    if (!finemote::is_fresh(state, finemote::now(), kReplyMaxAge)) state.valid = false;
    state.unreachable = !state.valid || slot_->bus().unreachable();
  }

  void handle() {
    const bool usable = finemote::is_fresh(command, finemote::now(), config_.max_age) && std::isfinite(command.torque);
    send(usable ? command.torque : 0);
  }

  void safe() { send(0); }

  finemote::MotorState state;
  finemote::MotorCommand command;

 private:
  static constexpr finemote::Duration kReplyMaxAge = 20 * finemote::kMillisecond;
  static constexpr std::uint32_t kMiddle16 = 0x7FFF, kMiddle12 = 0x7FF, kMost12 = 0xFFF, kMost16 = 0xFFFF;

  static float value(std::uint32_t word, std::uint32_t most_word, float most) {
    return (static_cast<float>(word) / static_cast<float>(most_word) * 2 - 1) * most;
  }

  void take(const finemote::CanSlot::Received& received) {
    const auto& data = received.frame.data;
    state.angle = value(std::uint32_t{data[1]} << 8 | data[2], kMost16, config_.most_angle);
    state.speed = value(std::uint32_t{data[3]} << 4 | std::uint32_t{data[4]} >> 4, kMost12, config_.most_speed);
    state.torque = value((std::uint32_t{data[4]} & 0xF) << 8 | data[5], kMost12, config_.most_torque);
    state.origin = received.at;
    state.valid = true;
  }

  void send(float torque) {
    const float share = finemote::clamp(torque / config_.most_torque, -1, 1);
    const auto word = static_cast<std::uint32_t>((share + 1) / 2 * kMost12);
    finemote::CanFrame frame{};
    frame.id = slot_->id();
    frame.size = 8;
    frame.data[0] = kMiddle16 >> 8;
    frame.data[1] = kMiddle16 & 0xFF;
    frame.data[2] = kMiddle12 >> 4;
    frame.data[3] = (kMiddle12 & 0xF) << 4;
    frame.data[6] = static_cast<std::uint8_t>(word >> 8);
    frame.data[7] = static_cast<std::uint8_t>(word & 0xFF);
    static_cast<void>(slot_->send(frame));
  }

  const Config config_;
  finemote::CanSlot* const slot_;
  std::uint32_t seen_ = 0;
};

}  // namespace stories
