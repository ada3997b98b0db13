#include "finemote/devices/ist8310.hpp"

#include "little_endian.hpp"

namespace finemote {

namespace {

// Registers of the IST8310 data sheet.
constexpr std::uint8_t kWhoAmI = 0x00, kIdentity = 0x10;
constexpr std::uint8_t kData = 0x03;  ///< x, y, z, low byte first

struct Setting {
  std::uint8_t address, value;
};
constexpr Setting kSettings[] = {
    {0x0B, 0x08},  // data-ready on, active low
    {0x41, 0x09},  // averages of two samples
    {0x42, 0xC0},  // pulse duration, as the data sheet asks for
    {0x0A, 0x0B},  // 200 measurements a second
};
constexpr std::uint8_t kSettingCount = sizeof kSettings / sizeof kSettings[0];

/// What a read brings is at most that old: 200 measurements a second are 5 ms apart (data sheet 5.3, CNTL1), and 1 ms
/// for what the part's clock may be slow. schemas/devices/ist8310.json has it as `latency_ns`.
constexpr Duration kFieldAge = 6 * kMillisecond;

/// The part counts its axes forward, to the right and up, which is left-handed: PX4/PX4-Autopilot,
/// src/drivers/magnetometer/isentek/ist8310/IST8310.cpp. Ours point to the left.
constexpr float kTeslaPerStep[3] = {0.3e-6F, -0.3e-6F, 0.3e-6F};
constexpr int kLargest[3] = {5400, 5400, 8400};  ///< 1600, 1600, 2500 uT
constexpr std::uint8_t kBadValues = 3;

}  // namespace

void Ist8310::update() {
  if (slot_->busy()) return;
  if (started_) {
    started_ = false;
    take_result();
  }
  begin_step();
}

void Ist8310::take_result() {
  if (!slot_->done()) {
    state.valid = false;
    if (slot_->unreachable()) step_ = Step::kIdentity;
    return;
  }
  switch (step_) {
    case Step::kIdentity:
      if (read_[0] != kIdentity) return;
      entry_ = 0;
      step_ = Step::kSettings;
      return;
    case Step::kSettings:
      if (++entry_ < kSettingCount) return;
      measured_ = false;
      step_ = Step::kRun;
      return;
    case Step::kRun:
      return take_field();
  }
}

void Ist8310::take_field() {
  int raw[3];
  bool good = false;
  for (int i = 0; i < 3; ++i) {
    raw[i] = int16_at(read_ + 2 * i);
    if (raw[i] > kLargest[i] || raw[i] < -kLargest[i]) return bad_value();
    good = good || raw[i] != 0;  // all zero: no measurement yet, or the part was reset
  }
  if (!good) {
    measured_ = false;
    return bad_value();
  }
  bad_values_ = 0;
  if (!measured_) {  // the part may have stored its first measurement in the middle of this read
    measured_ = true;
    state.valid = false;
    return;
  }
  for (int i = 0; i < 3; ++i) state.field[i] = static_cast<float>(raw[i]) * kTeslaPerStep[i];
  turn(mount_, state.field);
  state.origin = asked_ - kFieldAge;
  state.valid = true;
}

void Ist8310::bad_value() {
  state.valid = false;
  if (++bad_values_ < kBadValues) return;
  bad_values_ = 0;
  step_ = Step::kIdentity;
}

void Ist8310::begin_step() {
  switch (step_) {
    case Step::kIdentity:
      write_[0] = kWhoAmI;
      started_ = slot_->start(write_, 1, read_, 1);
      return;
    case Step::kSettings:
      write_[0] = kSettings[entry_].address;
      write_[1] = kSettings[entry_].value;
      started_ = slot_->start(write_, 2);
      return;
    case Step::kRun:
      write_[0] = kData;
      asked_ = now();
      started_ = slot_->start(write_, 1, read_, 6);
      return;
  }
}

}  // namespace finemote
