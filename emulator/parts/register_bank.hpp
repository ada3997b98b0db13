// A part on an I2C bus that is nothing but registers: the first byte written chooses one, further bytes are written or
// read from there on. Stands in for parts without a model.
#pragma once

#include <array>
#include <cstdint>

#include "emulator/chip/i2c_line.hpp"

namespace finemote::emulator {

class RegisterBank : public I2cPart {
 public:
  explicit RegisterBank(std::uint8_t address) : address_(address) {}

  bool select(std::uint8_t address, bool read) override {
    choosing_ = !read;
    return address == address_;
  }
  bool write(std::uint8_t byte) override {
    if (choosing_) {
      pointer_ = byte;
    } else {
      bytes[pointer_++] = byte;
    }
    choosing_ = false;
    return true;
  }
  std::uint8_t read() override { return bytes[pointer_++]; }
  void stop() override {}

  std::array<std::uint8_t, 256> bytes{};

 private:
  std::uint8_t address_, pointer_ = 0;
  bool choosing_ = false;
};

}  // namespace finemote::emulator
