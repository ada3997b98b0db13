// External interrupts: from a pin's edge to an interrupt line. RM0090 12.3, SYSCFG RM0090 9.2.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

class Exti : public Peripheral {
 public:
  explicit Exti(World& world) : Peripheral(world, "exti") {}
  std::uint32_t read(std::uint32_t offset) override {
    if (offset > 0x14) return unmodelled_read(offset);
    return offset == 0x14 ? pending_ : registers_[offset / 4];
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset > 0x14) return unmodelled_write(offset);
    if (offset != 0x14) only(value, offset == 0x04 ? 0 : 0xFFFF, offset == 0x04 ? "EMR" : "line");  // pins only
    if (offset == 0x14) {
      pending_ &= ~value;
      registers_[4] &= ~value;  // SWIER goes with it: RM0090 12.3.5
    } else {
      if (offset == 0x10) pending_ |= value & ~registers_[4] & registers_[0];
      registers_[offset / 4] = value;
    }
    update();
  }
  void reset() override {
    registers_ = {};
    pending_ = 0;
    update();
  }
  /// An edge on line 0..15 of the port SYSCFG chose.
  void edge(unsigned line, bool rising) {
    if ((registers_[rising ? 2 : 3] >> line & 1) == 0) return;
    pending_ |= 1U << line;
    update();
  }

 private:
  void update() {
    const std::uint32_t active = pending_ & registers_[0];
    for (int line = 0; line < 5; ++line) world_.set_line(6 + line, (active >> line & 1) != 0);
    world_.set_line(23, (active & 0x03E0) != 0);
    world_.set_line(40, (active & 0xFC00) != 0);
  }
  std::array<std::uint32_t, 5> registers_{};  // IMR, EMR, RTSR, FTSR, SWIER
  std::uint32_t pending_ = 0;
};

class Syscfg : public Peripheral {
 public:
  explicit Syscfg(World& world) : Peripheral(world, "syscfg") {}
  std::uint32_t read(std::uint32_t offset) override {
    return offset <= 0x20 ? registers_[offset / 4] : unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset > 0x20) return unmodelled_write(offset);
    only(value, offset >= 0x08 && offset <= 0x14 ? 0xFFFF : offset == 0 ? 3 : 0, "register");  // MEMRMP, EXTICR1 to 4
    registers_[offset / 4] = value;
    if (offset != 0) return;
    if (value == 1 || value == 2)
      world_.report(Misuse::unmodelled, "syscfg MEMRMP maps something else than flash or RAM");
    if (on_map) on_map(value == kRamAtZero);
  }
  void reset() override {
    registers_ = {};
    if (on_map) on_map(false);
  }
  /// Told what stands at address 0 from now on: SRAM1, or the flash.
  std::function<void(bool ram)> on_map;
  /// Port (0 = A) whose pin `line` is the source of EXTI `line`.
  [[nodiscard]] unsigned source(unsigned line) const { return registers_[2 + line / 4] >> (4 * (line % 4)) & 0xF; }

 private:
  static constexpr std::uint32_t kRamAtZero = 3;  ///< MEM_MODE: RM0090 9.2.1
  std::array<std::uint32_t, 9> registers_{};
};

}  // namespace finemote::emulator
