// A clock of a part that is off from the board's: converts between the times that both count.
#pragma once

#include <cmath>
#include <cstdint>

#include "emulator/parts/ready_output.hpp"

namespace finemote::emulator {

/// While the board counts a million steps, the part counts `ppm` more. At `phase` of the board it counts a multiple of
/// kGrid: samples that a part takes at multiples of their period fall on that instant. Without phase and error both
/// count the same.
class OwnClock {
 public:
  /// Every period of the parts' samples divides it: 80 ms / 2^n, 0.5 to 10 ms and 1.28 s of the BMI088 (its
  /// data sheet, ACC_CONF, GYRO_BANDWIDTH and 5.3.7), 5 ms of the IST8310 (its data sheet, CNTL1).
  static constexpr Time kGrid = from_ns(1'280'000'000);

  /// @param phase  time of the board
  /// @param ppm    how much faster it runs than the board's, -200000 to 200000
  OwnClock(PartClock board, Time phase, double ppm)
      : board_clock_(std::move(board)), rate_(static_cast<Time>(kBillion + std::llround(ppm * 1'000))) {
    lead_ = (kGrid - counted(phase) % kGrid) % kGrid;
  }

  /// What the part counts at a time of the board.
  [[nodiscard]] Time own(Time board) const { return counted(board) + lead_; }
  /// The first time of the board at which the part counts this; 0 if that was before power-on.
  [[nodiscard]] Time board(Time own) const {
    if (own <= lead_) return 0;
    const Time steps = own - lead_;
    return steps / rate_ * kBillion + (steps % rate_ * kBillion + rate_ - 1) / rate_;
  }
  /// For the part, which then counts by this clock whatever it does: its samples and the times to start, too.
  [[nodiscard]] PartClock part_clock() const {
    return {[clock = *this] { return clock.own(clock.board_clock_.now()); },
            [clock = *this](Time at, EventQueue::Action action) {
              clock.board_clock_.at(clock.board(at), std::move(action));
            }};
  }

 private:
  static constexpr std::int64_t kBillion = 1'000'000'000;

  /// In two pieces, so that no product leaves 64 bits.
  [[nodiscard]] Time counted(Time board) const {
    return board / kBillion * rate_ + board % kBillion * rate_ / kBillion;
  }

  PartClock board_clock_;
  Time rate_;      ///< steps of the part in 10^9 steps of the board
  Time lead_ = 0;  ///< what the part counts at power-on
};

}  // namespace finemote::emulator
