// PCA9685: sixteen PWM outputs set over I2C (data sheet NXP PCA9685 rev. 4).
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "emulator/chip/i2c_line.hpp"

namespace finemote::emulator {

class Pca9685 : public I2cPart {
 public:
  explicit Pca9685(std::uint8_t address) : address_(address) { power_cycle(); }

  /// As after its supply came up: asleep, all outputs off.
  void power_cycle() {
    registers_ = {};
    tags_ = {};
    registers_[kMode1] = 0x11;
    registers_[kPrescale] = 0x1E;
    for (unsigned c = 0; c < 16; ++c) registers_[kLed0 + 4 * c + 3] = 0x10;
    announce();
  }

  /// High time of an output [ns]; 0 while it is off, asleep, or never set.
  [[nodiscard]] std::uint64_t pulse_ns(unsigned channel) const { return asleep() ? 0 : width(channel); }
  [[nodiscard]] std::uint64_t period_ns() const { return 4096 * count_ns(); }
  /// Told at the STOP that changes an output.
  std::function<void(unsigned channel, std::uint64_t pulse_ns)> on_pulse;
  /// Told at the STOP that changes an output, or brings what it has from another origin.
  std::function<void(unsigned channel, std::uint64_t pulse_ns, Tag origin)> on_command;
  /// Told at the STOP for every channel that was written, with its pulse, changed or not.
  std::function<void(unsigned channel, std::uint64_t pulse_ns)> on_write;
  [[nodiscard]] unsigned bursts() const { return bursts_; }

  bool select(std::uint8_t address, bool read) override {
    const bool all_call = (registers_[kMode1] & 1) != 0 && address == 0x70 && !read;
    selected_ = address == address_ || all_call;
    at_start_ = !read;
    return selected_;
  }
  bool write(WireByte byte) override {
    if (at_start_) {
      pointer_ = byte;
      at_start_ = false;
      return true;
    }
    store(pointer_, byte);
    advance();
    changed_ = true;
    return true;
  }
  WireByte read() override {
    const std::uint8_t byte = registers_[pointer_];
    advance();
    return byte;
  }
  void stop() override {
    if (!selected_ || !changed_) return;
    selected_ = changed_ = false;
    ++bursts_;
    announce();
    for (unsigned c = 0; c < 16 && on_write; ++c) {
      if ((written_ >> c & 1) != 0) on_write(c, width(c));
    }
    written_ = 0;
  }

 private:
  static constexpr unsigned kMode1 = 0x00, kLed0 = 0x06, kAllLed = 0xFA, kPrescale = 0xFE;
  static constexpr std::uint64_t kClockNs = 40;  // 25 MHz, 7.3.5

  void announce() {
    for (unsigned c = 0; c < 16; ++c) {
      const std::uint64_t now = pulse_ns(c);
      const Tag* bytes = &tags_[kLed0 + 4 * c];
      const Tag origin = newest({bytes[0], bytes[1], bytes[2], bytes[3]});
      if (now != last_[c] && on_pulse) on_pulse(c, now);
      if ((now != last_[c] || origin != last_origin_[c]) && on_command) on_command(c, now, origin);
      last_[c] = now;
      last_origin_[c] = origin;
    }
  }
  [[nodiscard]] bool asleep() const { return (registers_[kMode1] & 0x10) != 0; }
  [[nodiscard]] std::uint64_t count_ns() const { return (registers_[kPrescale] + 1U) * kClockNs; }
  [[nodiscard]] std::uint64_t width(unsigned channel) const {
    const std::uint8_t* led = &registers_[kLed0 + 4 * channel];
    const unsigned on = led[0] | (led[1] & 0x0FU) << 8, off = led[2] | (led[3] & 0x0FU) << 8;
    if ((led[3] & 0x10) != 0) return 0;                  // full off wins: 7.3.3
    if ((led[1] & 0x10) != 0) return 4096 * count_ns();  // full on
    return ((off - on) & 0xFFF) * count_ns();
  }
  void store(std::uint8_t at, WireByte given) {
    std::uint8_t byte = given.value;
    if (at == kPrescale) {
      if (asleep()) registers_[at] = byte < 3 ? 3 : byte;  // only in sleep: 7.3.5
      return;
    }
    if (at == kMode1) {  // RESTART is set by going to sleep while running, and cleared by writing 1: 7.3.1.1
      const bool was = (registers_[kMode1] & 0x80) != 0, falls_asleep = !asleep() && (byte & 0x10) != 0;
      const bool restart = falls_asleep || (was && (byte & 0x80) == 0);
      byte = static_cast<std::uint8_t>((byte & 0x7F) | (restart ? 0x80 : 0));
    }
    if (at >= kAllLed && at < kAllLed + 4) {
      for (unsigned c = 0; c < 16; ++c) {
        registers_[kLed0 + 4 * c + (at - kAllLed)] = byte;
        tags_[kLed0 + 4 * c + (at - kAllLed)] = given.tag;
      }
      written_ = 0xFFFF;
      return;
    }
    registers_[at] = byte;
    tags_[at] = given.tag;
    if (at >= kLed0 && at < kLed0 + 64) written_ |= 1U << (at - kLed0) / 4;
  }
  /// Auto-increment wraps after LED15: 7.3.1.
  void advance() {
    if ((registers_[kMode1] & 0x20) == 0) return;
    pointer_ = pointer_ == 0x45 ? 0 : static_cast<std::uint8_t>(pointer_ + 1);
  }

  std::uint8_t address_, pointer_ = 0;
  std::array<std::uint8_t, 256> registers_{};
  std::array<Tag, 256> tags_{};  ///< of the registers
  std::array<std::uint64_t, 16> last_{};
  std::array<Tag, 16> last_origin_{};
  bool selected_ = false, at_start_ = false, changed_ = false;
  unsigned written_ = 0;  ///< channels, since the last STOP
  unsigned bursts_ = 0;
};

}  // namespace finemote::emulator
