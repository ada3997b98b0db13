// Reset and clock control: from register writes to the clocks everything else runs on. RM0090 7.
#pragma once

#include <array>
#include <functional>

#include "emulator/chip/backup_domain.hpp"
#include "emulator/chip/peripheral.hpp"

namespace finemote::emulator {

enum class ClockBus { always, ahb1, ahb2, apb1, apb2 };

class Rcc : public Peripheral {
 public:
  explicit Rcc(World& world) : Peripheral(world, "rcc") { reset(); }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) override;
  void reset() override;

  /// Any of these bits is set.
  [[nodiscard]] bool clocked(ClockBus bus, std::uint32_t bits) const;
  [[nodiscard]] std::uint32_t core_hz() const;
  [[nodiscard]] std::uint32_t apb1_hz() const { return core_hz() / divider(cfgr_ >> 10 & 7); }
  [[nodiscard]] std::uint32_t apb2_hz() const { return core_hz() / divider(cfgr_ >> 13 & 7); }
  /// Timers run at twice the bus clock when that is divided: RM0090 7.2.
  [[nodiscard]] std::uint32_t timer_hz(ClockBus bus) const;

  /// The PLL's output for USB and random numbers; 0: the PLL is not ready.
  [[nodiscard]] std::uint32_t usb_hz() const;
  /// Of the clock the backup domain chose for its calendar; 0: it stands.
  [[nodiscard]] std::uint32_t rtc_hz() const;

  /// What timers can measure inside: the LSI, and the crystal divided for the calendar. 0: it stands.
  [[nodiscard]] std::uint32_t running_lsi_hz() const { return (csr_ & 2) != 0 ? lsi_hz : 0; }
  [[nodiscard]] std::uint32_t divided_crystal_hz() const;

  /// Why the chip was reset, as RCC_CSR shows it (bits 25..31): until the firmware removes the flags, or a power reset
  /// does. RM0090 7.3.21.
  void note_reset(std::uint32_t cause) { csr_ = (cause & kPowerReset) != 0 ? cause : csr_ | cause; }
  static constexpr std::uint32_t kBrownOutReset = 1U << 25, kPinReset = 1U << 26, kPowerReset = 1U << 27,
                                 kSoftwareReset = 1U << 28, kWatchdogReset = 1U << 29, kWindowReset = 1U << 30;

  /// QEMU's board: 168 MHz from the first cycle, whatever is written. 0: the chip's own clocks.
  std::uint32_t fixed_hz = 0;
  /// The crystal never starts: a scenario's fault.
  bool dead_crystal = false;
  std::uint32_t crystal_hz = 12'000'000;
  std::uint32_t lsi_hz = 32'000;  ///< 17 to 47 kHz: DS8626 5.3.9
  BackupDomain backup;            ///< no reset of the system reaches it
  /// Asked for the flash's wait states when the clock changes; called with a peripheral's reset bits.
  std::function<unsigned()> wait_states;
  std::function<void(ClockBus, unsigned)> reset_peripheral;

 private:
  static constexpr std::uint32_t kResetFlags = 0x7FU << 25;

  static std::uint32_t divider(std::uint32_t field) { return field < 4 ? 1 : 2U << (field - 4); }
  [[nodiscard]] std::uint32_t pll_hz() const;
  void check_pll();
  Time as_slow(Time typical);
  void start(std::uint32_t ready_bit, Time delay);
  void write_cr(std::uint32_t value);
  void write_cfgr(std::uint32_t value);
  void apply();
  void switch_core();
  void write_csr(std::uint32_t value);
  void write_reset(ClockBus bus, std::uint32_t& field, std::uint32_t value);
  std::uint32_t* kept(std::uint32_t offset);

  std::uint32_t cr_ = 0, pllcfgr_ = 0, cfgr_ = 0, csr_ = 0;
  std::uint32_t ahb1_ = 0, ahb2_ = 0, ahb3_ = 0, apb1_ = 0, apb2_ = 0;
  std::uint32_t ahb3_reset_ = 0, spread_ = 0, audio_pll_ = 0;
  std::array<std::uint32_t, 6> sleep_clocks_{};
  std::uint32_t ahb1_reset_ = 0, ahb2_reset_ = 0, apb1_reset_ = 0, apb2_reset_ = 0;
};

}  // namespace finemote::emulator
