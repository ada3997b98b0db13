// The clock of the backup domain: a calendar, and twenty words that outlive a reset. RM0090 26.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

/// Alarms, wake-ups, time stamps and calibration are kept as written and do nothing.
class Rtc : public Peripheral {
 public:
  struct Wiring {
    std::function<std::uint32_t()> clock_hz;  ///< 0: its clock is off
    std::function<bool()> is_open;            ///< the backup domain may be written
  };
  Rtc(World& world, Wiring wiring) : Peripheral(world, "rtc"), wiring_(std::move(wiring)) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  /// A reset of the system locks the registers and leaves the clock alone.
  void reset() override { keys_ = 0; }
  /// The backup domain is reset: everything begins anew.
  void reset_domain();
  /// Its clock is about to change or has changed.
  void clock_changes() { settle(); }

 private:
  struct Calendar {
    unsigned second = 0, minute = 0, hour = 0, day = 1, month = 1, year = 0, weekday = 1;
    void advance(std::uint64_t seconds);
    [[nodiscard]] unsigned days_of_month() const;
  };

  void unlock(std::uint32_t key);
  void write_status(std::uint32_t value);
  void settle();
  [[nodiscard]] bool is_held() const { return (status_ & 0x80) != 0; }  // INIT
  [[nodiscard]] std::uint32_t time_register() const;
  [[nodiscard]] std::uint32_t date_register() const;
  [[nodiscard]] std::uint64_t ticks_a_second() const;

  Wiring wiring_;
  Calendar calendar_;
  std::uint32_t control_ = 0, status_ = 0, prescaler_ = 0x007F00FF;
  std::array<std::uint32_t, 20> backup_{};
  std::array<std::uint32_t, 20> others_{};  ///< what is only kept, by word
  unsigned keys_ = 0;
  Time since_ = 0;   ///< the calendar stood as it is
  double part_ = 0;  ///< of a second that has passed besides
};

}  // namespace finemote::emulator
