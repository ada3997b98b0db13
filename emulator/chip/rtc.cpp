#include "emulator/chip/rtc.hpp"

namespace finemote::emulator {
namespace {

enum Offset : std::uint32_t {
  kTime = 0x00,
  kDate = 0x04,
  kControl = 0x08,
  kStatus = 0x0C,
  kPrescaler = 0x10,
  kProtection = 0x24,
  kSubSecond = 0x28,
  kBackup = 0x50,
  kEnd = 0xA0
};
// ISR: RM0090 26.6.4.
constexpr std::uint32_t kAlarmsWritable = 3, kWakeUpWritable = 4, kInitialised = 16, kSynchronised = 32, kHeld = 64,
                        kHold = 128;
constexpr std::uint32_t kTwelveHours = 64, kTimers = 0xF00;  // CR: FMT; alarms, wake-up and time stamp

unsigned from_bcd(std::uint32_t value) { return (value >> 4) * 10 + (value & 0xF); }
std::uint32_t to_bcd(unsigned value) { return value / 10 << 4 | value % 10; }

}  // namespace

unsigned Rtc::Calendar::days_of_month() const {
  constexpr unsigned kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (month == 2 && year % 4 == 0) return 29;
  return month >= 1 && month <= 12 ? kDays[month - 1] : 31;
}

void Rtc::Calendar::advance(std::uint64_t seconds) {
  const std::uint64_t all = second + 60ULL * minute + 3600ULL * hour + seconds;
  second = static_cast<unsigned>(all % 60);
  minute = static_cast<unsigned>(all / 60 % 60);
  hour = static_cast<unsigned>(all / 3600 % 24);
  for (std::uint64_t days = all / 86'400; days > 0; --days) {
    weekday = weekday % 7 + 1;
    if (++day <= days_of_month()) continue;
    day = 1;
    month = month % 12 + 1;
    if (month == 1) year = (year + 1) % 100;
  }
}

void Rtc::reset_domain() {
  calendar_ = {};
  control_ = status_ = 0;
  prescaler_ = 0x007F00FF;
  backup_ = {};
  others_ = {};
  keys_ = 0;
  part_ = 0;
  since_ = world_.now();
}

std::uint64_t Rtc::ticks_a_second() const {
  return std::uint64_t{(prescaler_ >> 16 & 0x7F) + 1} * ((prescaler_ & 0x7FFF) + 1);
}

/// Lets the time that has passed reach the calendar.
void Rtc::settle() {
  const Time now = world_.now(), passed = now - since_;
  since_ = now;
  const std::uint32_t hz = wiring_.clock_hz();
  if (hz == 0 || is_held()) return;
  part_ += static_cast<double>(to_ns(passed)) * 1e-9 * hz / static_cast<double>(ticks_a_second());
  const auto whole = static_cast<std::uint64_t>(part_);
  part_ -= static_cast<double>(whole);
  calendar_.advance(whole);
}

std::uint32_t Rtc::time_register() const {
  const bool twelve = (control_ & kTwelveHours) != 0;
  const unsigned hour = twelve ? (calendar_.hour + 11) % 12 + 1 : calendar_.hour;
  const std::uint32_t afternoon = twelve && calendar_.hour >= 12 ? 1U << 22 : 0;
  return afternoon | to_bcd(hour) << 16 | to_bcd(calendar_.minute) << 8 | to_bcd(calendar_.second);
}

std::uint32_t Rtc::date_register() const {
  return to_bcd(calendar_.year) << 16 | calendar_.weekday << 13 | to_bcd(calendar_.month) << 8 | to_bcd(calendar_.day);
}

std::uint32_t Rtc::read(std::uint32_t offset) {
  settle();
  if (offset >= kBackup && offset < kEnd) return backup_[(offset - kBackup) / 4];
  switch (offset) {
    case kTime:
      return time_register();
    case kDate:
      return date_register();
    case kControl:
      return control_;
    case kStatus: {
      const bool runs = wiring_.clock_hz() != 0;
      return kAlarmsWritable | kWakeUpWritable | (calendar_.year != 0 ? kInitialised : 0) |
             (runs && !is_held() ? kSynchronised : 0) | (runs && is_held() ? kHeld : 0) | (status_ & kHold);
    }
    case kPrescaler:
      return prescaler_;
    case kProtection:
      return 0;
    case kSubSecond: {
      const std::uint32_t last = prescaler_ & 0x7FFF;
      return last - static_cast<std::uint32_t>(part_ * (last + 1));
    }
    default:
      return offset < kBackup ? others_[offset / 4] : unmodelled_read(offset);
  }
}

/// 26.3.5: two keys open the registers, anything else shuts them.
void Rtc::unlock(std::uint32_t key) {
  const bool second = keys_ == 1 && key == 0x53;
  keys_ = second ? 2 : key == 0xCA ? 1 : 0;
}

void Rtc::write_status(std::uint32_t value) {
  settle();
  status_ = value & kHold;
}

void Rtc::write(std::uint32_t offset, std::uint32_t value) {
  if (!wiring_.is_open()) return world_.report(Misuse::protocol, "rtc is written while the backup domain is locked");
  if (offset >= kBackup && offset < kEnd) {
    backup_[(offset - kBackup) / 4] = value;
    return;
  }
  if (offset == kProtection) return unlock(value);
  if (keys_ != 2) return world_.report(Misuse::protocol, "rtc is written without its keys");
  const bool sets_clock = offset == kTime || offset == kDate || offset == kPrescaler;
  if (sets_clock && !is_held()) return world_.report(Misuse::protocol, "rtc is set outside its initialisation mode");
  switch (offset) {
    case kTime: {
      const unsigned hour = from_bcd(value >> 16 & 0x3F);
      const bool afternoon = (value >> 22 & 1) != 0;
      calendar_.hour = (control_ & kTwelveHours) != 0 ? hour % 12 + (afternoon ? 12 : 0) : hour;
      calendar_.minute = from_bcd(value >> 8 & 0x7F);
      calendar_.second = from_bcd(value & 0x7F);
      part_ = 0;
      return;
    }
    case kDate:
      calendar_.year = from_bcd(value >> 16 & 0xFF);
      calendar_.weekday = value >> 13 & 7;
      calendar_.month = from_bcd(value >> 8 & 0x1F);
      calendar_.day = from_bcd(value & 0x3F);
      return;
    case kControl:
      only(value, ~kTimers, "CR");
      control_ = value;
      return;
    case kStatus:
      return write_status(value);
    case kPrescaler:
      prescaler_ = value & 0x007F7FFF;
      return;
    default:
      if (offset >= kBackup) return unmodelled_write(offset);
      others_[offset / 4] = value;
  }
}

}  // namespace finemote::emulator
