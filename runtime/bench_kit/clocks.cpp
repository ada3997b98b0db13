// The oscillators and clocks of the chip against each other. Whatever is said of one is said by another: the crystal by
// the HSI, which ST trimmed to 1 %; the board's clock and the LSI by the crystal.
#include "capture.hpp"
#include "groups.hpp"
#include "record.hpp"
#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace rcc = stm32f4::rcc;
using namespace board_clocks;

constexpr std::uint32_t kStarts = 8, kCrystalStarts = 4;
constexpr std::uint32_t kLimitUs = 100'000;
/// Half a megahertz of the crystal at the timer: what RTCPRE divides by, RM0090 7.3.3.
constexpr std::uint32_t kCrystalDivider = kCrystalHz / 500'000, kDividerShift = 16, kDividerMask = 31U << 16;
static_assert(kCrystalDivider >= 2 && kCrystalDivider <= 31);
constexpr std::uint32_t kCrystalCaptures = 64, kLsiCaptures = 16;
constexpr std::uint32_t kCrystalPeriods = kCrystalCaptures * kEdgesPerCapture * kCrystalDivider;
constexpr std::uint32_t kLsiPeriods = kLsiCaptures * kEdgesPerCapture;

/// `periods` of a clock of `hz` are so many of the other: its rate.
std::uint32_t rate(std::uint32_t hz, std::uint32_t periods, std::uint32_t others) {
  return static_cast<std::uint32_t>((std::uint64_t{hz} * others + periods / 2) / periods);
}

/// Turns on what `on` starts, as often as asked for, and keeps the longest time until it is ready.
/// @return whether it always came; it is on then
bool time_starts(const stm32f4::Register& control, std::uint32_t on, std::uint32_t ready, std::uint32_t times,
                 Test test) {
  const std::uint32_t limit = cycles_in(kLimitUs, kResetHz);
  for (std::uint32_t i = 0; i < times; ++i) {
    control.clear(on);
    if (!wait_until(control, ready, 0, limit)) return false;
    const Stopwatch watch;
    control.set(on);
    if (!wait_until(control, ready, ready, limit)) return false;
    put_largest(test, ns_of(watch.cycles(), kResetHz));
  }
  return true;
}

/// The PLL as the board's start sets it up: runtime/chips/stm32f4/clock.cpp.
void set_up_pll() {
  rcc::enable(rcc::apb1enr, rcc::kApb1Power);
  stm32f4::pwr::cr.set(stm32f4::pwr::kCrScale1);
  rcc::pllcfgr.write(kPllM | kPllN << 6 | (kPllP / 2 - 1) << 16 | rcc::kPllSourceHse | kPllQ << 24);
}

Captured count_crystal(std::uint32_t core_hz) {
  rcc::cfgr.modify(kDividerMask, kCrystalDivider << kDividerShift);
  return count_ticks(kCrystalInput, kCrystalCaptures, cycles_in(1'000, core_hz));
}

void measure_crystal() {
  const Captured found = count_crystal(kResetHz);
  if (found.ticks == 0) return miss(Test::clock_crystal_hz, Missing::answer);
  put(Test::clock_crystal_hz, rate(kResetHz, found.ticks, kCrystalPeriods));
}

}  // namespace

void time_low_oscillator() {
  if (!time_starts(rcc::csr, rcc::kCsrLsiOn, rcc::kCsrLsiReady, kStarts, Test::clock_lsi_start_ns))
    miss(Test::clock_lsi_start_ns, Missing::answer);
}

void time_oscillators() {
  miss(Test::clock_pll_lock_ns, Missing::answer);
  miss(Test::clock_crystal_hz, Missing::answer);
  if (!time_starts(rcc::cr, rcc::kCrHseOn, rcc::kCrHseReady, kCrystalStarts, Test::clock_crystal_start_ns))
    return miss(Test::clock_crystal_start_ns, Missing::answer);
  measure_crystal();
  set_up_pll();
  if (!time_starts(rcc::cr, rcc::kCrPllOn, rcc::kCrPllReady, kStarts, Test::clock_pll_lock_ns))
    miss(Test::clock_pll_lock_ns, Missing::answer);
  rcc::cr.clear(rcc::kCrPllOn);
}

void measure_clocks() {
  const Captured crystal = count_crystal(kCoreHz);
  if (crystal.ticks == 0) {
    miss(Test::clock_core_hz, Missing::answer);
  } else {
    put(Test::clock_core_hz, rate(kCrystalHz, kCrystalPeriods, crystal.ticks / (stm32f4::kApb2TimerHz / kCoreHz)));
  }
  const Captured lsi = count_ticks(kLsiInput, kLsiCaptures, cycles_in(2'000));
  if (lsi.ticks == 0) {
    miss(Test::clock_lsi_hz, Missing::answer);
    return miss(Test::clock_cycles_per_1000_ticks, Missing::answer);
  }
  put(Test::clock_lsi_hz, rate(stm32f4::kApb1TimerHz, lsi.ticks, kLsiPeriods));
  put(Test::clock_cycles_per_1000_ticks, rate(1'000, lsi.ticks, lsi.cycles));
}

}  // namespace finemote::bench_kit
