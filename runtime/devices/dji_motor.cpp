#include "finemote/devices/dji_motor.hpp"

#include <cmath>

#include "finemote/control/numbers.hpp"

namespace finemote {

namespace {

constexpr std::int32_t kTurn = 8192;  ///< steps of the rotor's angle
constexpr float kRadPerStep = 6.28318530718F / kTurn;
constexpr float kRadPerSecond = 6.28318530718F / 60;  ///< per rpm
constexpr float kStepsPerSecond = kTurn / 60.0F;      ///< per rpm
constexpr float kMaxRpm = 32000;
constexpr Duration kLongestGap = 1 * kSecond;  ///< beyond it the turns between two frames are not guessed

/// The same angle within half a turn: -kTurn / 2 < step <= kTurn / 2.
constexpr std::int32_t nearest_turn(std::int32_t step) {
  static_assert((kTurn & (kTurn - 1)) == 0, "the remainder is taken by a mask");
  constexpr std::int32_t kBelow = kTurn / 2 - 1;
  return ((step + kBelow) & (kTurn - 1)) - kBelow;
}

std::int16_t big_endian_at(const CanFrame& frame, unsigned at) {
  return static_cast<std::int16_t>(frame.data[at] << 8 | frame.data[at + 1]);
}

}  // namespace

void DjiMotor::update() {
  const CanSlot::Received received = slot_->received();
  if (received.count != seen_) {
    seen_ = received.count;
    take(received);
  }
  if (!is_fresh(state, now(), kFeedbackMaxAge)) state.valid = false;
  state.unreachable = !state.valid || slot_->bus().unreachable();
}

void DjiMotor::take(const CanSlot::Received& received) {
  const CanFrame& frame = received.frame;
  const std::int32_t angle = static_cast<std::uint16_t>(big_endian_at(frame, 0));
  const auto rpm = static_cast<float>(big_endian_at(frame, 2));
  if (frame.size != 8 || angle >= kTurn || rpm > kMaxRpm || rpm < -kMaxRpm) return;

  count_turns(angle, rpm, received.at);
  const float current =
      static_cast<float>(big_endian_at(frame, 4)) * kind_->full_current / static_cast<float>(kind_->full);
  state.angle = static_cast<float>(position_) * kRadPerStep / gear_;
  state.speed = rpm * kRadPerSecond / gear_;
  state.torque = current * kind_->torque_per_ampere * gear_;
  if (kind_->tells_temperature) state.temperature = frame.data[6];
  state.origin = received.at;
  state.valid = true;
}

void DjiMotor::count_turns(std::int32_t angle, float rpm, Time at) {
  std::int32_t step = angle - last_angle_;
  if (!counting_) {
    step = angle - static_cast<std::int32_t>(std::lround(zero_ / kRadPerStep));
    step = nearest_turn(step);
  } else {
    step += kTurn * whole_turns(static_cast<float>(step), rpm, at - last_at_);
  }
  counting_ = true;
  position_ += step;
  last_angle_ = angle;
  last_rpm_ = rpm;
  last_at_ = at;
}

/// How often the rotor turned besides `step`, by the mean of the speeds before and after. Without a gear nothing is
/// guessed across a silence: a wrong guess would be a whole turn of the output.
std::int32_t DjiMotor::whole_turns(float step, float rpm, Duration gap) const {
  const bool tells = gap <= kLongestGap && (state.valid || gear_ != 1);
  const float expected = tells ? (last_rpm_ + rpm) / 2 * seconds(gap) * kStepsPerSecond : 0;
  return static_cast<std::int32_t>(std::lround((expected - step) / kTurn));
}

void DjiMotor::handle() {
  const bool usable = is_fresh(command, now(), max_age_) && std::isfinite(command.torque);
  if (!usable) return drive(0);
  const auto full = static_cast<float>(kind_->full);
  const float word = command.torque / (gear_ * kind_->torque_per_ampere * kind_->full_current) * full;
  const float bounded = clamp(word, -full, full);
  drive(static_cast<std::int16_t>(bounded + (bounded < 0 ? -0.5F : 0.5F)));
}

void DjiMotor::safe() { drive(0); }

void DjiMotor::drive(std::int16_t word) {
  const auto bits = static_cast<std::uint16_t>(word);
  const std::uint8_t bytes[]{static_cast<std::uint8_t>(bits >> 8), static_cast<std::uint8_t>(bits & 0xFF)};
  slot_->set_shared(bytes);
}

}  // namespace finemote
