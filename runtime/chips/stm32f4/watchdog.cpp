// The independent watchdog: its own 32 kHz RC clock resets the board when the schedule stops.
#include "runtime/chips/stm32f4/registers/watchdog.hpp"
#include "finemote/board.hpp"
#include "runtime/chips/stm32f4/board_fault.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/registers/debug.hpp"
#include "runtime/chips/stm32f4/wait.hpp"

namespace finemote::board {
namespace {

namespace iwdg = stm32f4::iwdg;
namespace rcc = stm32f4::rcc;
using stm32f4::BoardFault;
using stm32f4::wait_for;

/// The fastest the LSI may run, which is when the watchdog bites earliest: DS8626 5.3.9.
constexpr std::uint64_t kLsiMaxHz = 47'000;
/// The period is a quarter longer than the longest gap between two feeds.
constexpr std::uint64_t kMarginNumerator = 5, kMarginDenominator = 4;
constexpr std::uint32_t kMaxCount = 4096, kLargestPrescaler = 6;

/// Fastest LSI clocks in `gap`, margin included, in 1/2^20 per 1024 ns: no 64-bit division on the target.
constexpr std::uint64_t kClocksPer1024ns =
    kLsiMaxHz * 1024 * (1U << 20) / 1'000'000'000 * kMarginNumerator / kMarginDenominator + 1;

constexpr std::uint32_t lsi_clocks(Duration gap) {
  const std::uint64_t units = (static_cast<std::uint64_t>(gap) >> 10) + 1;
  constexpr std::uint64_t kMost = std::uint64_t{kMaxCount} << (kLargestPrescaler + 2);
  const std::uint64_t clocks = units > (std::uint64_t{1} << 32) ? kMost : (units * kClocksPer1024ns >> 20) + 1;
  return static_cast<std::uint32_t>(clocks < kMost ? clocks : kMost);
}
static_assert(lsi_clocks(1'000'000'000) >= 58'750 && lsi_clocks(1'000'000'000) < 58'770);

/// The LSI is 17 kHz at slowest; an update of PR or RLR takes up to five of its clocks (RM0090 21.4.4): 0.3 ms.
constexpr std::uint32_t kUpdatePolls = 100'000;

}  // namespace

void start_watchdog(Duration longest_gap) {
  const std::uint32_t clocks = lsi_clocks(longest_gap);
  std::uint32_t prescaler = 0;  // divides by 4 << prescaler: RM0090 21.4.2
  while (prescaler < kLargestPrescaler && (clocks >> (prescaler + 2)) >= kMaxCount) ++prescaler;
  const std::uint32_t count = (clocks >> (prescaler + 2)) + 1;

  stm32f4::debug::apb1_freeze.set(stm32f4::debug::kFreezeWatchdog);  // a breakpoint is no fault
  iwdg::kr.write(iwdg::kKeyStart);                                   // turns the LSI on too: RM0090 21.3.1
  iwdg::kr.write(iwdg::kKeyUnlock);
  iwdg::pr.write(prescaler);
  iwdg::rlr.write((count < kMaxCount ? count : kMaxCount) - 1);
  if (!wait_for(iwdg::sr, iwdg::kSrPrescalerBusy | iwdg::kSrReloadBusy, 0, kUpdatePolls)) {
    count_fault(Module::board, static_cast<std::uint8_t>(BoardFault::watchdog));
  }
  feed_watchdog();
}

void feed_watchdog() { iwdg::kr.write(iwdg::kKeyReload); }

}  // namespace finemote::board
