#include "runtime/boards/host/ports/i2c_parts.hpp"

#include <cmath>

namespace finemote::host {

// -------------------------------------------------------------------------------------------------------------
// TCA9548A

bool Tca9548aPart::write(const std::vector<std::uint8_t>& bytes) {
  if (silent) return false;
  if (!bytes.empty()) channels_ = bytes.back();
  return true;
}

bool Tca9548aPart::read(std::size_t size, std::vector<std::uint8_t>& bytes) {
  if (silent) return false;
  bytes.assign(size, channels_);
  return true;
}

I2cPart* Tca9548aPart::behind(std::uint8_t address) {
  for (unsigned channel = 0; channel < 8; ++channel) {
    if ((channels_ >> channel & 1) == 0) continue;
    if (const auto found = parts_[channel].find(address); found != parts_[channel].end()) return found->second;
  }
  return nullptr;
}

// --------------------------------------------------------------------------------------------------------------
// PCA9685

namespace {
constexpr std::uint8_t kMode1 = 0x00, kLed0 = 0x06, kPrescale = 0xFE;
constexpr std::uint8_t kAutoIncrement = 0x20, kSleep = 0x10, kRestart = 0x80;
constexpr double kOscillator = 25e6;
}  // namespace

// Defaults: data sheet table 4.
void Pca9685Part::reset() {
  registers_.fill(0);
  registers_[kMode1] = 0x11;
  registers_[0x01] = 0x04;
  registers_[kPrescale] = 0x1E;
  for (unsigned n = 0; n < 16; ++n) registers_[kLed0 + 4 * n + 3] = 0x10;
  pointer_ = 0;
}

bool Pca9685Part::write(const std::vector<std::uint8_t>& bytes) {
  if (silent) return false;
  if (bytes.empty()) return true;
  pointer_ = bytes[0];
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    const bool asleep = (registers_[kMode1] & kSleep) != 0;
    if (pointer_ == kMode1) {
      registers_[kMode1] = static_cast<std::uint8_t>(bytes[i] & ~kRestart);
    } else if (pointer_ != kPrescale || asleep) {  // PRE_SCALE can be set only in sleep: 7.3.5
      registers_[pointer_] = bytes[i];
    }
    if ((registers_[kMode1] & kAutoIncrement) != 0)
      pointer_ = pointer_ == 69 ? 0 : static_cast<std::uint8_t>(pointer_ + 1);
  }
  Change change{now(), {}};
  for (unsigned n = 0; n < 16; ++n) change.pulses[n] = pulse(n);
  changes.push_back(change);
  return true;
}

bool Pca9685Part::read(std::size_t size, std::vector<std::uint8_t>& bytes) {
  if (silent) return false;
  for (std::size_t i = 0; i < size; ++i) {
    bytes.push_back(registers_[pointer_]);
    if ((registers_[kMode1] & kAutoIncrement) != 0) ++pointer_;
  }
  return true;
}

std::uint32_t Pca9685Part::pulse(unsigned channel) const {
  const std::uint8_t* led = registers_.data() + kLed0 + 4 * channel;
  if ((registers_[kMode1] & kSleep) != 0 || (led[3] & 0x10) != 0) return 0;
  const int on = led[0] | (led[1] & 0x0F) << 8, off = led[2] | (led[3] & 0x0F) << 8;
  return static_cast<std::uint32_t>(std::lround((off - on) * 1e9 * (registers_[kPrescale] + 1) / kOscillator));
}

// ---------------------------------------------------------------------------------------------------------------
// MS5837

Ms5837Part::Ms5837Part(Ms5837::Variant variant) : variant_(variant) {
  // The worked examples of the data sheets.
  static constexpr std::uint16_t kWide[6] = {34982, 36352, 20328, 22354, 26646, 26146};
  static constexpr std::uint16_t kNarrow[6] = {46372, 43981, 29059, 27842, 31553, 28165};
  for (unsigned i = 0; i < 6; ++i) {
    calibration.c[i + 1] = variant == Ms5837::Variant::k30BA ? kWide[i] : kNarrow[i];
  }
  calibration.c[0] = static_cast<std::uint16_t>(Ms5837::crc4(calibration) << 12);
  set(101325, 20);
}

void Ms5837Part::reset() {
  running_ = result_ = 0;
  ready_ = 0;
}

// Both compensations grow with their raw value: bisection.
void Ms5837Part::set(double pressure, double temperature) {
  const auto search = [](auto value_of, double wanted) {
    std::uint32_t low = 1, high = 0xFFFFFF;
    while (low < high) {
      const std::uint32_t middle = (low + high) / 2;
      if (value_of(middle) < wanted) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  };
  const double unit = variant_ == Ms5837::Variant::k30BA ? 10 : 1;
  d2_ = search([&](std::uint32_t d2) { return Ms5837::compensate(variant_, calibration, 1, d2).temperature; },
               temperature * 100);
  d1_ = search([&](std::uint32_t d1) { return Ms5837::compensate(variant_, calibration, d1, d2_).pressure; },
               pressure / unit);
}

bool Ms5837Part::write(const std::vector<std::uint8_t>& bytes) {
  if (silent || now() < reset_until_) return false;
  if (bytes.empty()) return true;
  command_ = bytes[0];
  if (command_ == 0x1E) {
    reset();
    reset_until_ = now() + 2800 * kMicrosecond;
  } else if ((command_ & 0xF0) == 0x40 || (command_ & 0xF0) == 0x50) {
    running_ = (command_ & 0xF0) == 0x40 ? d1_ : d2_;
    ready_ = now() + Ms5837::conversion_time(256 << (command_ & 0x0F) / 2);
    ++conversions;
  }
  return true;
}

bool Ms5837Part::read(std::size_t size, std::vector<std::uint8_t>& bytes) {
  if (silent || now() < reset_until_) return false;
  bytes.assign(size, 0);
  if (command_ == 0x00 && size == 3) {
    if (running_ == 0 || now() < ready_) return true;  // no result: zeros
    const std::uint32_t result = (running_ ^ noise) & 0xFFFFFF;
    running_ = 0;
    bytes = {static_cast<std::uint8_t>(result >> 16), static_cast<std::uint8_t>(result >> 8),
             static_cast<std::uint8_t>(result)};
  } else if ((command_ & 0xF0) == 0xA0 && size == 2) {
    std::uint16_t word = calibration.c[(command_ & 0x0F) / 2];
    if (bad_prom && command_ == 0xA4) word ^= 0x0100;
    bytes = {static_cast<std::uint8_t>(word >> 8), static_cast<std::uint8_t>(word)};
  }
  return true;
}

}  // namespace finemote::host
