#include "runtime/boards/robomaster_type_c/clock.hpp"

#include "finemote/fault.hpp"
#include "runtime/boards/robomaster_type_c/board_fault.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"
#include "runtime/boards/robomaster_type_c/wait.hpp"

namespace finemote::robomaster_type_c {
namespace {

namespace rcc = stm32f407::rcc;
namespace flash = stm32f407::flash;
namespace pwr = stm32f407::pwr;

// PLL, RM0090 7.3.2: input 12 MHz / 6 = 2 MHz, VCO 2 MHz * 168 = 336 MHz, core 336 / 2, USB 336 / 7.
constexpr std::uint32_t kM = 6, kN = 168, kP = 2, kQ = 7;
static_assert(kCrystalHz / kM == 2'000'000, "the manual advises 2 MHz against jitter");
static_assert(kCrystalHz / kM * kN / kP == 168'000'000 && kCrystalHz / kM * kN / kQ == 48'000'000);
constexpr std::uint32_t kPllcfgr = kM | kN << 6 | (kP / 2 - 1) << 16 | stm32f407::rcc::kPllSourceHse | kQ << 24;

// CFGR, RM0090 7.3.3: AHB not divided, APB1 by 4 (42 MHz), APB2 by 2 (84 MHz).
constexpr std::uint32_t kApb1By4 = 5U << 10, kApb2By2 = 4U << 13;
constexpr std::uint32_t kPrescalers = kApb1By4 | kApb2By2, kPrescalerMask = 0xFU << 4 | 7U << 10 | 7U << 13;

// 168 MHz at 2.7 V to 3.6 V needs five wait states: RM0090 3.5.1, table 10.
constexpr std::uint32_t kWaitStates = 5;

// At the 16 MHz reset clock a poll takes 0.25 us or more. A crystal takes about 2 ms (DS8626 5.3.8), the PLL at most
// 0.3 ms (DS8626 5.3.10); these bounds are 100 ms and 10 ms.
constexpr std::uint32_t kCrystalPolls = 400'000, kPllPolls = 40'000, kSwitchPolls = 40'000, kFlashPolls = 1'000;

[[noreturn]] void fail(BoardFault fault, const char* text) {
  stop_safely(Module::board, static_cast<std::uint8_t>(fault), text);
}

void start_crystal() {
  rcc::cr.set(rcc::kCrHseOn);
  if (!wait_for(rcc::cr, rcc::kCrHseReady, rcc::kCrHseReady, kCrystalPolls))
    fail(BoardFault::crystal, "the crystal does not start");
}

void start_flash() {
  flash::acr.write(kWaitStates | flash::kPrefetch | flash::kInstructionCache | flash::kDataCache);
  if (!wait_for(flash::acr, flash::kLatencyMask, kWaitStates, kFlashPolls))
    fail(BoardFault::flash_wait, "the flash takes no wait states");
}

void start_pll() {
  rcc::enable(rcc::apb1enr, rcc::kApb1Power);
  pwr::cr.set(pwr::kCrScale1);  // takes effect when the PLL is on: RM0090 5.1.4
  rcc::pllcfgr.write(kPllcfgr);
  rcc::cr.set(rcc::kCrPllOn);
  if (!wait_for(rcc::cr, rcc::kCrPllReady, rcc::kCrPllReady, kPllPolls)) fail(BoardFault::pll, "the PLL does not lock");
}

void switch_to_pll() {
  rcc::cfgr.modify(kPrescalerMask, kPrescalers);
  rcc::cfgr.modify(rcc::kCfgrSwitchMask, rcc::kCfgrSwitchPll);
  if (!wait_for(rcc::cfgr, rcc::kCfgrStatusMask, rcc::kCfgrStatusPll, kSwitchPolls)) {
    fail(BoardFault::clock_switch, "the core stays on its reset clock");
  }
}

}  // namespace

void start_clock() {
  start_crystal();
  start_flash();
  start_pll();
  switch_to_pll();
}

}  // namespace finemote::robomaster_type_c
