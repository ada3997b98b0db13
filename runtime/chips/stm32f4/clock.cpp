#include "runtime/chips/stm32f4/clock.hpp"

#include "finemote/fault.hpp"
#include "runtime/chips/stm32f4/board_fault.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/registers/debug.hpp"
#include "runtime/chips/stm32f4/wait.hpp"

namespace finemote::stm32f4 {
namespace {

using namespace board_clocks;

// PLL, RM0090 7.3.2: the crystal by M, times N is the VCO; by P the core, by Q the USB.
constexpr std::uint32_t kInputHz = kCrystalHz / kPllM;
static_assert(kInputHz == 2'000'000 || kInputHz == 1'000'000, "1 to 2 MHz; the manual advises 2 MHz against jitter");
static_assert(kInputHz * kPllN / kPllP == kCoreHz && kInputHz * kPllN / kPllQ <= 48'000'000);
constexpr std::uint32_t kPllcfgr = kPllM | kPllN << 6 | (kPllP / 2 - 1) << 16 | rcc::kPllSourceHse | kPllQ << 24;

/// Field of CFGR that divides the core clock for a bus, RM0090 7.3.3: 4 is by 2, 5 by 4, 6 by 8, 7 by 16.
constexpr std::uint32_t prescaler(std::uint32_t bus_hz) {
  std::uint32_t halvings = 0;
  while (kCoreHz >> halvings > bus_hz) ++halvings;
  return halvings == 0 ? 0 : 3 + halvings;
}
// AHB is not divided.
constexpr std::uint32_t kPrescalers = prescaler(kApb1Hz) << 10 | prescaler(kApb2Hz) << 13,
                        kPrescalerMask = 0xFU << 4 | 7U << 10 | 7U << 13;

// At 2.7 V to 3.6 V one for every 30 MHz begun beyond the first: RM0090 3.5.1, table 10.
constexpr std::uint32_t kWaitStates = kFlashWaitStates;
static_assert(kWaitStates >= (kCoreHz - 1) / 30'000'000);

// At the 16 MHz reset clock a poll takes 0.25 us or more. A crystal takes about 2 ms (DS8626 5.3.8), the PLL at most
// 0.3 ms (DS8626 5.3.10); these bounds are 100 ms and 10 ms.
constexpr std::uint32_t kCrystalPolls = 400'000, kPllPolls = 40'000, kSwitchPolls = 40'000, kFlashPolls = 1'000;

[[noreturn]] void fail(BoardFault fault, const char* text) {
  stop_safely(Module::board, static_cast<std::uint8_t>(fault), text);
}

/// A boot loader may have left the core on a PLL, and both are off while one is set up: RM0090 7.3.2.
void leave_pll() {
  if (!rcc::cr.any(rcc::kCrPllOn | rcc::kCrAudioPllOn)) return;
  rcc::cr.set(rcc::kCrHsiOn);
  const bool is_ready = wait_for(rcc::cr, rcc::kCrHsiReady, rcc::kCrHsiReady, kSwitchPolls);
  rcc::cfgr.modify(rcc::kCfgrSwitchMask, rcc::kCfgrSwitchHsi);
  if (!is_ready || !wait_for(rcc::cfgr, rcc::kCfgrStatusMask, rcc::kCfgrStatusHsi, kSwitchPolls))
    fail(BoardFault::clock_switch, "the core stays on the clock of a boot loader");
  rcc::cr.clear(rcc::kCrPllOn | rcc::kCrAudioPllOn);
  if (!wait_for(rcc::cr, rcc::kCrPllReady | rcc::kCrAudioPllReady, 0, kPllPolls))
    fail(BoardFault::pll, "the PLL does not stop");
}

void start_crystal() {
  rcc::cr.set(rcc::kCrHseOn);
  if (!wait_for(rcc::cr, rcc::kCrHseReady, rcc::kCrHseReady, kCrystalPolls))
    fail(BoardFault::crystal, "the crystal does not start");
}

/// Revision A reads as another chip, and cannot prefetch: ES0182.
std::uint32_t prefetch() {
  return (debug::idcode.read() & debug::kDeviceMask) == debug::kStm32f407 ? flash::kPrefetch : 0;
}

void start_flash() {
  flash::acr.write(kWaitStates | prefetch() | flash::kInstructionCache | flash::kDataCache);
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
  leave_pll();
  start_crystal();
  start_flash();
  start_pll();
  switch_to_pll();
}

}  // namespace finemote::stm32f4
