// The PCA9685 of the robot, whose pulses the speed controllers set: written by transfers that return when they have
// ended.
#pragma once

#include "finemote/pca9685.hpp"

namespace baseline {

constexpr unsigned kThrusters = 8;

class PulseBoard : public finemote::PwmOutput {
 public:
  constexpr PulseBoard() : PwmOutput(channel_, kThrusters, 20'000'000, false) {}

  /// 50 Hz, every output at `neutral` [ns]. Context: start.
  void start(std::uint32_t neutral);

  bool select() const;
  /// Four transactions, one for each register of the channel. Selected before.
  void write_registers(std::uint8_t channel) const;
  /// One transaction for the channel's four registers. @return  whether it was acknowledged
  bool write_channel(std::uint8_t channel) const;
  /// One transaction for all channels. @return  whether it was acknowledged
  bool write_all() const;

 private:
  void put(std::uint8_t* registers, std::uint8_t channel) const;

  Channel channel_[kThrusters];
};

}  // namespace baseline
