// What all times rest on: the cycle counter while the core sleeps, what follows a WFI, the flash behind its
// accelerator, and the way into an interrupt and back.
#include "groups.hpp"
#include "record.hpp"
#include "runtime/chips/cortex_m4/registers.hpp"
#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace flash = stm32f4::flash;
namespace nvic = cortex_m4::nvic;
namespace rcc = stm32f4::rcc;
using stm32f4::bit;
using stm32f4::Register;

/// DBGMCU_CR, RM0090 38.16.3: the core's clock goes on in sleep.
constexpr Register kDebugControl{0xE0042004};
constexpr std::uint32_t kDebugSleep = bit(0);

/// TIM5 counts; its first channel wakes the core. RM0090 12.2, table 62; 18.4.
constexpr stm32f4::TimerRegisters kClock = stm32f4::kTim5.timer;
constexpr Register kClockInterrupts{kClock.base + 0x0C}, kClockStatus{kClock.base + 0x10},
    kClockCount{kClock.base + 0x24};
constexpr unsigned kClockLine = 50;
constexpr std::uint32_t kFirstChannel = bit(1), kTicksPerUs = stm32f4::kApb1TimerHz / 1'000'000,
                        kCyclesPerTick = kCoreHz / stm32f4::kApb1TimerHz;

void reset_clock() { rcc::restart(rcc::apb1enr, stm32f4::kTim5.clock_bit); }

void start_clock() {
  rcc::enable(rcc::apb1enr, stm32f4::kTim5.clock_bit);
  reset_clock();
  kClockInterrupts.write(kFirstChannel);
  kClock.cr1().write(stm32f4::timer::kCr1Enable);
}

/// Wakes the core in so long, whatever it sleeps in: a pending line does also where interrupts are masked.
void set_alarm(std::uint32_t us) {
  kClock.ccr(1).write(kClockCount.read() + us * kTicksPerUs);
  kClockStatus.write(0);
  nvic::clear_pending(kClockLine);
}

/// Cycles that the counter lacks after a sleep of a millisecond, by the timer.
std::uint32_t cycles_lost_in_sleep() {
  constexpr std::uint32_t kSleepUs = 1'000;
  set_alarm(kSleepUs);
  const std::uint32_t begin = kClockCount.read();
  const Stopwatch watch;
  asm volatile("dsb\n\twfi" ::: "memory");
  const std::uint32_t counted = watch.cycles();
  const std::uint32_t passed = (kClockCount.read() - begin) * kCyclesPerTick;
  return passed > counted ? passed - counted : 0;
}

/// Sleeps at an address that ends in Place of 8, and counts what it does behind it: four instructions.
template <unsigned Place>
__attribute__((naked, noinline, aligned(8))) std::uint32_t sleep_and_count() {
  static_assert(Place >= 2 && Place <= 8 && Place % 2 == 0);
  asm volatile(
      "movs r0, #0\n\t"
      ".rept %c0\n\tnop\n\t.endr\n\t"
      "wfi\n\t"
      ".rept 4\n\tadds r0, #1\n\t.endr\n\t"
      "bx lr" ::"i"(Place / 2 - 1));
}

std::uint32_t instructions_lost() {
  constexpr std::uint32_t kRounds = 16, kSleepUs = 20, kCounted = 4;
  constexpr std::uint32_t (*kSleeps[])() = {sleep_and_count<2>, sleep_and_count<4>, sleep_and_count<6>,
                                            sleep_and_count<8>};
  std::uint32_t lost = 0;
  for (std::uint32_t i = 0; i < kRounds; ++i) {
    for (const auto sleep : kSleeps) {
      set_alarm(kSleepUs);
      lost += kCounted - sleep();
    }
  }
  return lost;
}

/// Straight code: 256 instructions of a halfword in 32 lines of flash.
constexpr std::uint32_t kLines = 32, kInstructions = 8 * kLines;
__attribute__((naked, noinline, aligned(16))) void run_straight() {
  asm volatile(".rept 256\n\tadds r0, #1\n\t.endr\n\tbx lr" ::: "r0");
}

__attribute__((naked, noinline, aligned(16))) void return_at_once() { asm volatile("bx lr"); }

__attribute__((noinline)) std::uint32_t time_call(void (*code)()) {
  const Stopwatch watch;
  code();
  return watch.cycles();
}

/// Of the straight code alone. Caches hold it and the way to it if they are on.
std::uint32_t time_straight() {
  static_cast<void>(time_call(run_straight));
  static_cast<void>(time_call(return_at_once));
  return time_call(run_straight) - time_call(return_at_once);
}

volatile std::uint32_t entered, left;

}  // namespace

void measure_sleep() {
  const cortex_m4::Masked masked;
  start_clock();
  nvic::enable(kClockLine);
  put(Test::sleep_cycles_lost, cycles_lost_in_sleep());
  kDebugControl.set(kDebugSleep);
  put(Test::sleep_cycles_lost_with_debug_clock, cycles_lost_in_sleep());
  put(Test::sleep_instructions_lost, instructions_lost());
  kDebugControl.clear(kDebugSleep);
  nvic::disable(kClockLine);
  reset_clock();
}

// RM0090 3.9.1: the caches are emptied while they are off.
void measure_flash() {
  constexpr std::uint32_t kEmptyCaches = bit(11) | bit(12);
  const std::uint32_t usual = flash::acr.read();
  flash::acr.write(usual & flash::kLatencyMask);
  flash::acr.set(kEmptyCaches);
  flash::acr.clear(kEmptyCaches);
  const std::uint32_t bare = time_straight();
  flash::acr.write(usual);
  const std::uint32_t fast = time_straight();
  put(Test::flash_wait_cycles_per_line, bare < fast ? 0 : (bare - fast + kLines / 2) / kLines);
  put(Test::flash_cycles_per_100_instructions, fast * 100 / kInstructions);
}

void measure_interrupt() {
  constexpr unsigned kRounds = 64;
  const Stopwatch twice;
  const std::uint32_t reading = twice.cycles();  // what the counter takes to be read
  cortex_m4::enable_line(kFreeLine, cortex_m4::kBusPriority);
  for (unsigned i = 0; i < kRounds; ++i) {
    const std::uint32_t before = cortex_m4::cycles();
    stm32f4::pend_line(kFreeLine);
    asm volatile("dsb\n\tisb" ::: "memory");
    const std::uint32_t after = cortex_m4::cycles();
    put_largest(Test::interrupt_entry_ns, ns_of(entered - before - reading));
    put_largest(Test::interrupt_exit_ns, ns_of(after - left - reading));
  }
  nvic::disable(kFreeLine);
}

}  // namespace finemote::bench_kit

extern "C" void FINEMOTE_BENCH_LINE() {
  finemote::bench_kit::entered = finemote::cortex_m4::cycles();
  finemote::bench_kit::left = finemote::cortex_m4::cycles();
}
