// TCA9548A: connects eight I2C buses to one, as its control byte says (data sheet SCPS207, 8.6.2).
#pragma once

#include <array>
#include <cstdint>

#include "emulator/chip/i2c_line.hpp"

namespace finemote::emulator {

class Tca9548a : public I2cPart {
 public:
  explicit Tca9548a(std::uint8_t address) : address_(address) {}

  /// The bus behind channel 0..7.
  I2cLine& channel(unsigned index) { return channels_[index]; }
  [[nodiscard]] std::uint8_t control() const { return control_; }
  [[nodiscard]] unsigned writes() const { return writes_; }
  /// The part loses its setting, as after a drop of its supply.
  void power_cycle() { control_ = next_ = 0; }

  bool select(std::uint8_t address, bool read) override {
    self_ = address == address_;
    if (self_) return true;
    through_ = 0;
    for (unsigned i = 0; i < 8; ++i) {
      if ((control_ >> i & 1) != 0 && channels_[i].select(address, read))
        through_ = static_cast<std::uint8_t>(through_ | 1U << i);
    }
    return through_ != 0;
  }
  bool write(WireByte byte) override {
    if (self_) {
      next_ = byte;  // takes effect at the STOP
      ++writes_;
      return true;
    }
    bool acknowledged = false;
    for (unsigned i = 0; i < 8; ++i) {
      if ((through_ >> i & 1) != 0) acknowledged = channels_[i].write(byte) || acknowledged;
    }
    return acknowledged;
  }
  WireByte read() override {
    if (self_) return control_;
    WireByte byte = 0xFF;
    for (unsigned i = 0; i < 8; ++i) {
      if ((through_ >> i & 1) != 0) byte &= channels_[i].read();
    }
    return byte;
  }
  void stop() override {
    for (unsigned i = 0; i < 8; ++i) {
      if ((control_ >> i & 1) != 0) channels_[i].stop();
    }
    control_ = next_;
    self_ = false;
    through_ = 0;
  }

 private:
  std::uint8_t address_, control_ = 0, next_ = 0, through_ = 0;
  bool self_ = false;
  unsigned writes_ = 0;
  std::array<I2cLine, 8> channels_;
};

}  // namespace finemote::emulator
