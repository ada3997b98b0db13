// Two pulse outputs behind I2C: a register number, then the pulse of each channel in microseconds.
#pragma once

#include <finemote/i2c.hpp>
#include <finemote/pwm.hpp>

namespace my {

class Pair : public finemote::PwmOutput {
 public:
  struct Config {
    std::int64_t rate = 50;  ///< Hz
  };
  constexpr Pair(finemote::I2cSlot& slot, const Config& config)
      : PwmOutput(channel_, 2, static_cast<std::uint32_t>(1000000000 / config.rate), false), slot_(&slot) {}

  void flush() {
    if (slot_->busy()) return;
    bytes_[0] = 1;
    for (unsigned i = 0; i < 2; ++i) {
      const std::uint32_t pulse = channel_[i].pulse.load() / 1000;
      bytes_[1 + 2 * i] = static_cast<std::uint8_t>(pulse >> 8);
      bytes_[2 + 2 * i] = static_cast<std::uint8_t>(pulse & 0xFF);
    }
    slot_->start(bytes_, sizeof bytes_);
  }

 private:
  finemote::I2cSlot* slot_;
  std::uint8_t bytes_[5]{};
  Channel channel_[2];
};

}  // namespace my
