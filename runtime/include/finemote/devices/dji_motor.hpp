// Turns torque into the current word of a DJI speed controller, and its feedback frames into a continuous angle.
#pragma once

#include <cstdint>

#include "finemote/can.hpp"
#include "finemote/contract.hpp"
#include "finemote/interfaces/motor.hpp"

namespace finemote {

/// What sets one kind of DJI motor with its controller apart.
struct DjiMotorKind {
  std::int16_t full;        ///< command word for `full_current`
  float full_current;       ///< A
  float torque_per_ampere;  ///< N m at the rotor's side of the gear
  bool tells_temperature;   ///< else the byte for it means nothing
};

/// Common to all kinds; use DjiM3508, DjiM2006 or DjiGm6020.
///
/// Feedback comes by itself, 1000 times a second: rotor angle 0..8191, speed [rpm], current and, but of a C610, the
/// temperature. The state's
/// origin is when the last frame was made at the earliest; 20 ms without one, or with impossible values, make it
/// invalid and the motor unreachable. The angle counts turns, helped by the speed where more than half a turn passes
/// between two updates; the first one is within half a turn of the rotor either way of where the encoder's zero is said
/// to be. Behind a silence that made the state invalid, the angle of a motor without gear is within half a turn of the
/// last one; with a gear the turns are a guess from the speeds before and after, and unknown behind more than a second.
///
/// Drives while its command is valid, a number, and made from data not older than `max_age`; otherwise no current. Four
/// motors share one frame: handle() sets the motor's two bytes, the bus sends the frame once at the end of the bucket.
class DjiMotor {
 public:
  static constexpr Duration kFeedbackMaxAge = 20 * kMillisecond;

  void update();
  void handle();
  /// No current at the next flush. May interrupt update() and handle().
  void safe();

  MotorState state;
  MotorCommand command;

 protected:
  /// @param zero  what the encoder reads where the angle is zero [rad of the rotor]
  constexpr DjiMotor(const DjiMotorKind& kind, float gear, Duration max_age, CanSlot& slot, float zero = 0)
      : kind_(&kind), slot_(&slot), gear_(gear), zero_(zero), max_age_(max_age) {}

 private:
  void take(const CanSlot::Received& received);
  void count_turns(std::int32_t angle, float rpm, Time at);
  [[nodiscard]] std::int32_t whole_turns(float step, float rpm, Duration gap) const;
  void drive(std::int16_t word);

  const DjiMotorKind* const kind_;
  CanSlot* const slot_;
  const float gear_;
  const float zero_;
  const Duration max_age_;
  std::uint32_t seen_ = 0;
  std::int32_t last_angle_ = 0;
  float last_rpm_ = 0;
  Time last_at_ = 0;
  bool counting_ = false;
  std::int64_t position_ = 0;  ///< rotor, 8192 per turn
};

namespace detail {
inline constexpr DjiMotorKind kC620{16384, 20, 0.3F * 187 / 3591, true};
inline constexpr DjiMotorKind kC610{10000, 10, 0.18F / 36, false};
inline constexpr DjiMotorKind kGm6020{16384, 3, 0.741F, true};
}  // namespace detail

}  // namespace finemote
