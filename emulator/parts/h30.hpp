// H30 inertial unit on a serial line: a frame with acceleration, rates, angles and attitude at a fixed rate.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "emulator/parts/frame_sender.hpp"

namespace finemote::emulator {

/// What the unit feels; angles in degrees, rates in degrees per second, acceleration in m/s^2.
struct Attitude {
  std::array<double, 3> acceleration{0, 0, 9.81}, rate{};
  double pitch = 0, roll = 0, yaw = 0;
};

/// The bytes of one frame: 0x59 0x53, number, length, records, two sums.
std::vector<std::uint8_t> h30_frame(std::uint16_t number, const Attitude& attitude);

class H30 : public FrameSender {
 public:
  /// @param period  between the beginnings of two frames; the first begins after `phase`
  H30(World& world, Usart& usart, const SerialFormat& format, Time period, Time phase,
      std::function<Attitude(Time)> attitude);

 private:
  std::vector<std::uint8_t> make_frame(Time now) override { return h30_frame(number_++, attitude_(now)); }

  std::function<Attitude(Time)> attitude_;
  std::uint16_t number_ = 0;
};

}  // namespace finemote::emulator
