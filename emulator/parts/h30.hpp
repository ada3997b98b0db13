// H30 inertial unit on a serial line: a frame with acceleration, rates, angles and attitude at a fixed rate.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "emulator/chip/peripheral.hpp"
#include "emulator/chip/usart.hpp"

namespace finemote::emulator {

/// What the unit feels; angles in degrees, rates in degrees per second, acceleration in m/s^2.
struct Attitude {
  std::array<double, 3> acceleration{0, 0, 9.81}, rate{};
  double pitch = 0, roll = 0, yaw = 0;
};

/// The bytes of one frame: 0x59 0x53, number, length, records, two sums.
std::vector<std::uint8_t> h30_frame(std::uint16_t number, const Attitude& attitude);

/// A frame that is due while the one before is still on its way is left out: the line is too slow for the rate.
class H30 {
 public:
  /// @param period  between the beginnings of two frames; the first begins after `phase`
  H30(World& world, Usart& usart, const SerialFormat& format, Time period, Time phase,
      std::function<Attitude(Time)> attitude);

  /// Asked what the bytes of a frame carry that is made and begins now.
  std::function<Tag()> on_sample;
  bool silent = false;          ///< sends nothing
  unsigned damaged_frames = 0;  ///< the next ones carry a wrong sum
  [[nodiscard]] unsigned frames() const { return frames_; }

 private:
  void send();

  World& world_;
  Usart& usart_;
  SerialFormat format_;
  Time period_;
  std::function<Attitude(Time)> attitude_;
  std::uint16_t number_ = 0;
  unsigned frames_ = 0;
};

}  // namespace finemote::emulator
