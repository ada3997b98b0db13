// Power control: the core's voltage, and access to the backup domain. RM0090 5.4.
#pragma once

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// No low-power modes, no voltage detector.
class Pwr : public Peripheral {
 public:
  explicit Pwr(World& world) : Peripheral(world, "pwr") {}
  std::uint32_t read(std::uint32_t offset) override {
    if (offset == 0) return cr_;
    if (offset == 4) return csr_ | kVoltageReady;
    return unmodelled_read(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == 0) {
      only(value, 0x410C, "CR");  // VOS, DBP and the clearing of flags
      cr_ = value & 0x4100;
    } else if (offset == 4) {
      only(value, kVoltageReady | kBackupRegulator | kBackupReady, "CSR");
      csr_ = (value & kBackupRegulator) != 0 ? kBackupRegulator | kBackupReady : 0;
    } else {
      unmodelled_write(offset);
    }
  }
  void reset() override {
    cr_ = 0x4000;
    csr_ = 0;
  }
  /// The backup domain may be written: RTC, its clock and the backup registers.
  [[nodiscard]] bool opens_backup() const { return (cr_ & 0x100) != 0; }

 private:
  static constexpr std::uint32_t kBackupReady = 1U << 3, kBackupRegulator = 1U << 9, kVoltageReady = 1U << 14;
  std::uint32_t cr_ = 0x4000, csr_ = 0;
};

}  // namespace finemote::emulator
