// A part on an I2C bus that is nothing but registers: the first byte written chooses one, further bytes are written or
// read from there on. Stands in for parts without a model.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "emulator/chip/i2c_line.hpp"

namespace finemote::emulator {

class RegisterBank : public I2cPart {
 public:
  explicit RegisterBank(std::uint8_t address) : address_(address) {}

  bool select(std::uint8_t address, bool read) override {
    end();
    choosing_ = !read;
    if (address != address_) return false;
    if (read && on_sample) sample_ = on_sample();
    return true;
  }
  bool write(WireByte byte) override {
    if (choosing_) {
      pointer_ = byte;
    } else {
      if (on_write) on_write(pointer_, byte);
      bytes[pointer_++] = byte;
    }
    choosing_ = false;
    return true;
  }
  WireByte read() override { return {bytes[pointer_++], sample_}; }
  void stop() override { end(); }

  std::array<std::uint8_t, 256> bytes{};
  /// Asked, when a read begins, what its bytes carry; told at its end.
  std::function<Tag()> on_sample;
  std::function<void(Tag sample)> on_read;
  /// Told of every register that is written.
  std::function<void(unsigned number, WireByte byte)> on_write;

 private:
  void end() {
    if (sample_ != Tag::none && on_read) on_read(sample_);
    sample_ = Tag::none;
  }

  std::uint8_t address_, pointer_ = 0;
  bool choosing_ = false;
  Tag sample_ = Tag::none;  ///< of the read under way
};

}  // namespace finemote::emulator
