// IST8310 magnetometer: 0.3 uT a step, measures on demand or by itself (iSentek data sheet IST8310). Its y axis points
// to the right: what it counts along it is the field to the left with the other sign.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "emulator/chip/i2c_line.hpp"
#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

class Ist8310 : public I2cPart {
 public:
  /// @param field  at a time, forward, left and up as seen from the part [T]
  Ist8310(std::uint8_t address, std::function<Time()> now, std::function<Eigen::Vector3d(Time)> field)
      : address_(address), now_(std::move(now)), field_(std::move(field)) {
    reset();
  }

  bool select(std::uint8_t address, bool read) override {
    selected_ = address == address_ && !dead && !held_;
    at_start_ = !read;
    return selected_;
  }
  bool write(WireByte byte) override {
    if (at_start_) {
      pointer_ = byte;
      at_start_ = false;
    } else {
      store(pointer_++, byte);
    }
    return true;
  }
  WireByte read() override {
    if (pointer_ == kStatus) registers_[kStatus] = converted() > noticed_ ? 1 : 0;
    if (pointer_ == kData) measure();
    const std::uint8_t at = pointer_++;
    return {registers_[at], at >= kData && at < kData + 6 ? sample_ : Tag::none};
  }
  void stop() override { selected_ = false; }

  /// The RSTN pin.
  void hold_reset(bool held) {
    held_ = held;
    if (held) reset();
  }
  void power_cycle() { reset(); }
  bool dead = false;  ///< acknowledges nothing
  /// Told when a measurement is read. @return what its bytes carry
  std::function<Tag(Time from)> on_read;

 private:
  static constexpr std::uint8_t kWho = 0x00, kStatus = 0x02, kData = 0x03, kControl1 = 0x0A, kControl2 = 0x0B;

  void reset() {
    registers_ = {};
    registers_[kWho] = 0x10;
    pointer_ = 0;
    converted_ = kNever;
    noticed_ = 0;
    sample_ = Tag::none;
  }
  void store(std::uint8_t at, std::uint8_t byte) {
    if (at == kControl2 && (byte & 1) != 0) return reset();
    if (at >= kControl1) registers_[at] = byte;
    if (at == kControl1 && byte == 1) converted_ = now_() + from_ns(kConversionNs);
  }
  /// When the last conversion ended; 0: none has. 0x0B: 200 a second by itself; 0x01: one.
  [[nodiscard]] Time converted() const {
    constexpr Time kPeriod = from_ns(5'000'000);
    if (registers_[kControl1] == 0x0B) return now_() / kPeriod * kPeriod;
    return converted_ <= now_() ? converted_ : 0;
  }
  /// Puts into the registers what the last conversion gave.
  void measure() {
    const Time ended = converted();
    if (ended == 0) return;
    noticed_ = ended;
    const bool by_itself = registers_[kControl1] == 0x0B;
    if (!by_itself) registers_[kControl1] = 0;
    const Time taken = by_itself ? ended : ended - from_ns(kConversionNs);
    const Eigen::Vector3d field = field_(taken);
    for (unsigned i = 0; i < 3; ++i) {
      const double along = i == 1 ? -field[i] : field[i];
      const auto word = static_cast<std::uint16_t>(std::lround(along / 0.3e-6));
      registers_[kData + 2U * i] = static_cast<std::uint8_t>(word);
      registers_[kData + 2U * i + 1] = static_cast<std::uint8_t>(word >> 8);
    }
    if (on_read) sample_ = on_read(taken);
  }

  static constexpr std::uint64_t kConversionNs = 6'000'000;
  std::uint8_t address_, pointer_ = 0;
  std::function<Time()> now_;
  std::function<Eigen::Vector3d(Time)> field_;
  std::array<std::uint8_t, 256> registers_{};
  Time converted_ = kNever;  ///< of a single measurement: its end
  Time noticed_ = 0;         ///< the end of the conversion that was read last; its status bit is gone
  Tag sample_ = Tag::none;   ///< what the data registers hold
  bool selected_ = false, at_start_ = false, held_ = false;
};

}  // namespace finemote::emulator
