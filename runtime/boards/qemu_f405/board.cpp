// QEMU's netduinoplus2 as a board: an exact core and SysTick, no clocks to start, no watchdog, no buses.
#include "finemote/board.hpp"

#include "report.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "semihosting.hpp"

namespace finemote {
namespace board {

void start_hardware() {}
bool restarted_unasked() { return false; }
void start_watchdog(Duration) {}
void feed_watchdog() {}
void say(const char* text) {
  if (text != nullptr) qemu_f405::write(text);
}
void stopped() {
  qemu_f405::report_run();
  qemu_f405::report_stop();
  qemu_f405::exit(1);
}

}  // namespace board

namespace cortex_m4 {

void start_cycles(std::uint32_t) {}

// QEMU's cycle counter reads 0; SysTick counts the same clock. Nothing here is more urgent than the release interrupt,
// so a wrap that was not yet served can be seen only with interrupts masked, where the pending bit tells.
std::uint32_t cycles() {
  for (;;) {
    const Interval interval = release_interval();
    const std::uint32_t pending = scb::InterruptControl::read() & scb::kSysTickPending;
    const std::uint32_t left = systick::Value::read();
    const bool wrapped = (scb::InterruptControl::read() & scb::kSysTickPending) != 0;
    if (wrapped != (pending != 0) || release_interval().begin != interval.begin) continue;
    const std::uint32_t reload = wrapped ? systick::Reload::read() + 1 : interval.length;
    const std::uint32_t begin = wrapped ? interval.begin + interval.length : interval.begin;
    return begin + (left == 0 ? 0 : reload - left);
  }
}

void idle() {
  for (;;) {
    qemu_f405::report_events();
    asm volatile("wfi" : : : "memory");
  }
}

void run_ended() {
  qemu_f405::report_run();
  qemu_f405::exit(0);
}

}  // namespace cortex_m4

// One instruction is 8 ns with -icount shift=3, a turn of the loop two instructions.
void busy(Duration work) {
  constexpr Duration kTurn = 16;
  while (work > kSecond) {
    cortex_m4::spin(static_cast<std::uint32_t>(kSecond / kTurn));
    work -= kSecond;
  }
  if (work > 0) cortex_m4::spin(static_cast<std::uint32_t>(work) / static_cast<std::uint32_t>(kTurn));
}

}  // namespace finemote
