// The checksum unit: words into a CRC-32 with the polynomial 0x04C11DB7. RM0090 4.
#pragma once

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Crc : public Peripheral {
 public:
  explicit Crc(World& world) : Peripheral(world, "crc") {}

  std::uint32_t read(std::uint32_t offset) override {
    if (offset == kDr) return sum_;
    if (offset == kIdr) return kept_;
    return offset == kCr ? 0 : unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kDr) {
      sum_ ^= value;
      for (unsigned bit = 0; bit < 32; ++bit) sum_ = sum_ << 1 ^ ((sum_ >> 31) != 0 ? 0x04C11DB7U : 0);
    } else if (offset == kIdr) {
      kept_ = value & 0xFF;
    } else if (offset == kCr) {
      if ((value & 1) != 0) sum_ = ~0U;
    } else {
      unmodelled_write(offset);
    }
  }
  void reset() override {
    sum_ = ~0U;
    kept_ = 0;
  }

 private:
  enum Offset : std::uint32_t { kDr = 0, kIdr = 4, kCr = 8 };
  std::uint32_t sum_ = ~0U, kept_ = 0;
};

}  // namespace finemote::emulator
