#include "capture.hpp"

#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace rcc = stm32f4::rcc;
using stm32f4::bit;
using stm32f4::Register;
using stm32f4::TimerRegisters;

// RM0090 18.4.5, 18.4.7, 18.4.9, 18.4.20.
constexpr std::uint32_t kFromOwnInput = 1, kEveryEighth = 3U << 2, kOvercaptureShift = 8;

constexpr Register status(const TimerRegisters& timer) { return Register{timer.base + 0x10}; }
constexpr Register option(const TimerRegisters& timer) { return Register{timer.base + 0x50}; }

/// Waits for the next capture. @return false: it does not come, or one was lost
bool take(const CaptureInput& input, std::uint32_t limit_cycles, std::uint32_t& at) {
  const Register flags = status(input.timer.timer);
  if (!wait_until(flags, bit(input.channel), bit(input.channel), limit_cycles)) return false;
  at = input.timer.timer.ccr(input.channel).read();  // clears the flag
  return !flags.any(bit(input.channel + kOvercaptureShift));
}

constexpr Register enable_of(const stm32f4::TimerPeripheral& timer) {
  return timer.is_on_apb1() ? rcc::apb1enr : rcc::apb2enr;
}

void set_up(const CaptureInput& input) {
  const TimerRegisters timer = input.timer.timer;
  rcc::enable(enable_of(input.timer), input.timer.clock_bit);
  rcc::restart(enable_of(input.timer), input.timer.clock_bit);
  option(timer).write(input.remap);
  const std::uint32_t index = input.channel - 1;
  timer.ccmr(index / 2).write((kFromOwnInput | kEveryEighth) << index % 2 * 8);
  timer.ccer().write(bit(4 * index));
  timer.cr1().write(stm32f4::timer::kCr1Enable);
}

}  // namespace

Captured count_ticks(const CaptureInput& input, std::uint32_t captures, std::uint32_t limit_cycles) {
  constexpr std::uint32_t kCounterMask = 0xFFFF;  // some timers have no more
  set_up(input);
  Captured all;
  std::uint32_t before = 0;
  bool has_come = take(input, limit_cycles, before) && take(input, limit_cycles, before);  // the first is any
  const Stopwatch watch;
  for (std::uint32_t i = 0; has_come && i < captures; ++i) {
    std::uint32_t at = 0;
    has_come = take(input, limit_cycles, at);
    all.ticks += (at - before) & kCounterMask;
    before = at;
  }
  all.cycles = watch.cycles();
  rcc::restart(enable_of(input.timer), input.timer.clock_bit);
  return has_come ? all : Captured{};
}

}  // namespace finemote::bench_kit
