// The flash interface (RM0090 3.9) and power control (RM0090 5.4): a few bits each.
#pragma once

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Flash : public Peripheral {
 public:
  explicit Flash(World& world) : Peripheral(world, "flash") {}
  std::uint32_t read(std::uint32_t offset) override {
    if (offset == 0x00) return acr_;
    if (offset == 0x0C) return 0;           // SR: nothing under way
    if (offset == 0x10) return 0x80000000;  // CR: locked
    return unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset != 0x00) return unmodelled_write(offset, value);
    only(value, 0x1F07, "ACR");
    acr_ = value & 0x0707;
  }
  void reset() override { acr_ = 0; }
  [[nodiscard]] unsigned wait_states() const { return acr_ & 7; }

 private:
  std::uint32_t acr_ = 0;
};

class Pwr : public Peripheral {
 public:
  explicit Pwr(World& world) : Peripheral(world, "pwr") {}
  std::uint32_t read(std::uint32_t offset) override {
    if (offset == 0) return cr_;
    if (offset == 4) return 1U << 14;  // VOSRDY
    return unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == 0) {
      only(value, 0x410C, "CR");  // VOS, DBP and the clearing of flags
      cr_ = value;
    } else if (offset != 4) {
      unmodelled_write(offset, value);
    }
  }
  void reset() override { cr_ = 0x4000; }

 private:
  std::uint32_t cr_ = 0x4000;
};

}  // namespace finemote::emulator
