// USB OTG FS as a port without a cable: its registers answer, and nothing ever comes. RM0090 34.
#pragma once

#include <map>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// Control registers keep what is written; resets and flushes end at once. No interrupt is raised, not that of a bus at
/// rest either; FIFOs take data and give none.
class Usb : public Peripheral {
 public:
  explicit Usb(World& world) : Peripheral(world, "usb_otg_fs") {}
  static constexpr unsigned kKib = 256;  ///< of its addresses

  std::uint32_t read(std::uint32_t offset) override {
    if (offset >= kFifos) return 0;
    if (offset == kReset) return kBusIdle;
    if (offset == kStatus) return is_host() ? 1 : 0;
    if (offset == kDeviceStatus) return 3U << 1;  // full speed
    const auto found = registers_.find(offset);
    if (found != registers_.end()) return found->second;
    return reset_value(offset);
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset >= kFifos || offset == kReset || offset == kStatus || is_endpoint_status(offset)) return;
    if (is_endpoint_control(offset) && (value & kDisable) != 0) value &= ~(kDisable | kEnable);
    registers_[offset] = value;
  }
  void reset() override { registers_.clear(); }

 private:
  enum Offset : std::uint32_t {
    kUsbConfiguration = 0x0C,
    kReset = 0x10,
    kStatus = 0x14,
    kReceiveSize = 0x24,
    kTransmitSize = 0x28,
    kTransmitStatus = 0x2C,
    kCoreId = 0x3C,
    kDeviceStatus = 0x808,
    kEndpoints = 0x900,
    kPower = 0xE00,
    kFifos = 0x1000
  };
  static constexpr std::uint32_t kBusIdle = 1U << 31;  ///< GRSTCTL: 34.16.2
  static constexpr std::uint32_t kEnable = 1U << 31, kDisable = 1U << 30;
  static constexpr std::uint32_t kFifoRoom = 0x80;  ///< words that fit into the FIFO of an endpoint

  /// GUSBCFG.FHMOD.
  [[nodiscard]] bool is_host() const {
    const auto found = registers_.find(kUsbConfiguration);
    return found != registers_.end() && (found->second >> 29 & 1) != 0;
  }
  static bool is_endpoint(std::uint32_t offset) { return offset >= kEndpoints && offset < kPower; }
  static bool is_endpoint_control(std::uint32_t offset) { return is_endpoint(offset) && offset % 0x20 == 0; }
  static bool is_endpoint_status(std::uint32_t offset) { return is_endpoint(offset) && offset % 0x20 == 8; }
  static std::uint32_t reset_value(std::uint32_t offset) {
    if (offset == kUsbConfiguration) return 0x1440;
    if (offset == kReceiveSize || offset == kTransmitSize) return 0x200;
    if (offset == kTransmitStatus) return 0x00080200;
    if (offset == kCoreId) return 0x1100;
    const bool is_in = offset < 0xB00;
    return is_endpoint(offset) && is_in && offset % 0x20 == 0x18 ? kFifoRoom : 0;  // DTXFSTS
  }

  std::map<std::uint32_t, std::uint32_t> registers_;
};

}  // namespace finemote::emulator
