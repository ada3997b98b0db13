// IST8310 magnetometer: 0.3 uT a step, measures on demand or by itself (iSentek data sheet IST8310). Its y axis points
// to the right: what it counts along it is the field to the left with the other sign.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "emulator/chip/i2c_line.hpp"
#include "emulator/parts/ready_output.hpp"
#include "emulator/plants/motion.hpp"

namespace finemote::emulator {

/// A measurement is ready from its end until its first byte is read: STAT1 says so, and the pin DRDY where CNTL2 turns
/// it on. The data sheet's words on the pin leave open whether it also falls by itself; here it does not.
class Ist8310 : public I2cPart {
 public:
  /// @param field  at a time, forward, left and up as seen from the part [T]; asked in the order of time
  Ist8310(std::uint8_t address, PartClock clock, std::function<Eigen::Vector3d(Time)> field)
      : address_(address), clock_(std::move(clock)), field_(std::move(field)) {
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
    if (pointer_ == kData) take_notice();
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
  /// Told the level of DRDY when that changes: 1, 0, or -1: it drives nothing.
  std::function<void(int level)> on_ready;
  [[nodiscard]] std::uint64_t measurements() const { return measurements_; }

 private:
  static constexpr std::uint8_t kWho = 0x00, kStatus = 0x02, kData = 0x03, kControl1 = 0x0A, kControl2 = 0x0B;
  static constexpr std::uint8_t kReady = 1, kOverrun = 2;                           // STAT1
  static constexpr std::uint8_t kSingle = 0x01, kContinuous = 0x0B;                 // CNTL1
  static constexpr std::uint8_t kSoftReset = 1, kActiveHigh = 4, kDrivesReady = 8;  // CNTL2
  static constexpr Time kConversion = from_ns(6'000'000), kPeriod = from_ns(5'000'000);

  void reset() {
    registers_ = {};
    registers_[kWho] = 0x10;
    registers_[kControl2] = kActiveHigh | kDrivesReady;
    pointer_ = 0;
    sample_ = Tag::none;
    measured_at_reset_ = measurements_;
    ++token_;
    show();
  }
  void store(std::uint8_t at, std::uint8_t byte) {
    if (at == kControl2 && (byte & kSoftReset) != 0) return reset();
    if (at >= kControl1) registers_[at] = byte;
    if (at == kControl2) show();
    if (at != kControl1) return;
    ++token_;
    const Time now = clock_.now();
    if (byte == kSingle) plan(now + kConversion, now);
    if (byte == kContinuous) plan_next((now / kPeriod + 1) * kPeriod);
  }
  /// 200 a second by itself, at the multiples of their period; what is measured is ready at once.
  void plan_next(Time at) { plan(at, at); }
  void plan(Time at, Time taken) {
    clock_.at(at, [this, at, taken, token = token_] {
      if (token != token_) return;
      measure(taken);
      if (registers_[kControl1] == kContinuous) plan_next(at + kPeriod);
      if (registers_[kControl1] == kSingle) registers_[kControl1] = 0;
    });
  }
  void measure(Time taken) {
    const Eigen::Vector3d field = field_(taken);
    for (unsigned i = 0; i < 3; ++i) {
      const double along = i == 1 ? -field[i] : field[i];
      const auto word = static_cast<std::uint16_t>(std::lround(along / 0.3e-6));
      registers_[kData + 2U * i] = static_cast<std::uint8_t>(word);
      registers_[kData + 2U * i + 1] = static_cast<std::uint8_t>(word >> 8);
    }
    const bool unread = (registers_[kStatus] & kReady) != 0;
    registers_[kStatus] = static_cast<std::uint8_t>(unread ? kReady | kOverrun : kReady);
    taken_ = taken;
    ++measurements_;
    show();
  }
  /// The data are about to be read.
  void take_notice() {
    if (measurements_ == measured_at_reset_) return;  // there are none
    registers_[kStatus] = 0;
    if (on_read) sample_ = on_read(taken_);
    show();
  }
  void show() {
    const std::uint8_t control = registers_[kControl2];
    const bool active = (registers_[kStatus] & kReady) != 0, high = active == ((control & kActiveHigh) != 0);
    const int level = (control & kDrivesReady) == 0 ? -1 : high ? 1 : 0;
    if (level != level_ && on_ready) on_ready(level);
    level_ = level;
  }

  std::uint8_t address_, pointer_ = 0;
  PartClock clock_;
  std::function<Eigen::Vector3d(Time)> field_;
  std::array<std::uint8_t, 256> registers_{};
  Time taken_ = 0;          ///< when what the data registers hold was measured
  Tag sample_ = Tag::none;  ///< what they carry
  int level_ = -1;
  bool selected_ = false, at_start_ = false, held_ = false;
  std::uint64_t token_ = 0, measurements_ = 0, measured_at_reset_ = 0;
};

}  // namespace finemote::emulator
