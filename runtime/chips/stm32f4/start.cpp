// An STM32F4 as the runtime sees it: hardware start, cycle counter, text.
#include "finemote/board.hpp"
#include "finemote/fault.hpp"

#include "board/resting_pins.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/stm32f4/board_fault.hpp"
#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/pin.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/registers/gpio.hpp"

namespace finemote {
namespace {

using stm32f4::PinMode;
using stm32f4::PinSetup;

/// Data watchpoint and trace unit: Armv7-M Architecture Reference Manual C1.8.7, C1.8.8, C1.6.5.
constexpr stm32f4::Register kDwtControl{0xE0001000}, kDwtCycles{0xE0001004}, kDemcr{0xE000EDFC};
constexpr std::uint32_t kTraceEnable = stm32f4::bit(24), kCountEnable = stm32f4::bit(0);

/// The flash at address 0 as after a reset: the boot loader in the system memory leaves itself there. Code in SRAM has
/// mapped that.
void map_flash() {
#ifndef FINEMOTE_CODE_IN_SRAM
  stm32f4::rcc::enable(stm32f4::rcc::apb2enr, stm32f4::rcc::kApb2Syscfg);
  stm32f4::syscfg::memrmp.write(stm32f4::syscfg::kFlashAtZero);
#endif
}

/// Pins of parts on the board that must be quiet until somebody uses them, as its file says.
void rest_onboard_parts() {
  for (const stm32f4::RestingPin& rest : stm32f4::kRestingPins) {
    stm32f4::rcc::enable(stm32f4::rcc::ahb1enr, stm32f4::bit(static_cast<unsigned>(rest.pin.port - 'A')));
    rest.pin.set(rest.high);  // the level first, so that the pin never shows the other one
    stm32f4::configure(rest.pin, PinSetup{PinMode::output});
  }
}

}  // namespace

namespace board {

void start_hardware() {
  map_flash();
  stm32f4::start_clock();
  rest_onboard_parts();
}

/// The flags stay until they are removed, so that every start sees its own cause: RM0090 7.3.21. A sagging supply sets
/// that of the brown-out alone, one that is switched on that of power-on too.
bool restarted_unasked() {
  using namespace stm32f4;
  const std::uint32_t causes = rcc::csr.read();
  rcc::csr.set(rcc::kCsrRemoveFlags);
  const bool by_watchdog = (causes & (rcc::kCsrIwdgReset | rcc::kCsrWwdgReset)) != 0;
  const bool by_supply = (causes & (rcc::kCsrBrownOut | rcc::kCsrPowerReset)) == rcc::kCsrBrownOut;
  if (by_watchdog) count_fault(Module::board, static_cast<std::uint8_t>(BoardFault::restarted));
  if (by_supply) count_fault(Module::board, static_cast<std::uint8_t>(BoardFault::brown_out));
  return by_watchdog || by_supply;
}

void say(const char*) {}  // nobody listens: a debugger reads the fault records

void stopped() {}

}  // namespace board

namespace cortex_m4 {

std::uint32_t cycles() { return kDwtCycles.read(); }

void start_cycles(std::uint32_t value) {
  kDemcr.set(kTraceEnable);
  kDwtCycles.write(value);
  kDwtControl.set(kCountEnable);
}

// A jump to itself, not WFI: the cycle counter stops in sleep unless the debug clock is kept on, and with it on the
// first instructions behind a WFI in flash may be fetched wrongly (ES0182, "Debugging Sleep/Stop mode with WFE/WFI
// entry"). It also reads no memory that a debug probe may want while the core sleeps.
void idle() {
  for (;;) asm volatile("");
}

}  // namespace cortex_m4

// A turn of the loop takes at most 5 cycles: the subtraction 1, the branch 1 + P, where P, the refill of the pipeline,
// is 1 to 3 (Cortex-M4 TRM, table 3-1). From SRAM the work is never longer than asked for, and up to 40 % shorter. It
// is split into halves of 32 bits, each of which tools can follow.
void busy(Duration work) {
  constexpr std::uint32_t kTurnsPerMs = cortex_m4::kCoreHz / 5 / 1'000;
  constexpr std::uint32_t kHigh = UINT32_MAX / 1'000'000 * kTurnsPerMs;  // of 2^32 ns, which are 4.3 s
  const auto high = static_cast<std::int32_t>(work >> 32);
  if (high < 0) return;
  for (std::int32_t left = high; left != 0; --left) cortex_m4::spin(kHigh);
  const auto ns = static_cast<std::uint32_t>(work);
  cortex_m4::spin(ns / 1'000'000 * kTurnsPerMs + ns % 1'000'000 / 1'000 * kTurnsPerMs / 1'000);
}

}  // namespace finemote
