// PwmPort on the timers: edge-aligned PWM mode 1 with preload, RM0090 17.3.10 (TIM1, TIM8), 18.3.9 (TIM4, TIM5), 19.3.9
// (TIM10).
#include <numeric>

#include "finemote/fault.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/ports/pwm_hardware.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote {
namespace {

namespace rcc = stm32f4::rcc;
namespace timer = stm32f4::timer;
using stm32f4::PwmSetup;

enum class PwmFault : std::uint8_t {
  period = 1,   ///< out of kShortestPwmPeriod .. kLongestPwmPeriod
  two_periods,  ///< outputs of one timer share its period: the later one is refused
};

/// The smallest whole number of nanoseconds that are a whole number of counts, the same on both buses: at 168 MHz 125
/// ns are 21 counts, at 84 MHz 250 ns. With them 32 bits are enough: 400 ms are 67,200,000 counts.
constexpr std::uint32_t unit_ns(std::uint32_t hz) { return 1'000'000'000U / std::gcd(hz, 1'000'000'000U); }
constexpr std::uint32_t kNanoseconds2 = unit_ns(stm32f4::kApb2TimerHz), kNanoseconds1 = unit_ns(stm32f4::kApb1TimerHz);
constexpr std::uint32_t kCounts = stm32f4::kApb2TimerHz / (1'000'000'000U / kNanoseconds2);
static_assert(std::uint64_t{stm32f4::kApb1TimerHz} * kNanoseconds1 == std::uint64_t{kCounts} * 1'000'000'000);
static_assert(kLongestPwmPeriod / kNanoseconds2 < 0xFFFFFFFFU / kCounts);

constexpr std::uint32_t nanoseconds(const PwmSetup& setup) {
  return setup.is_on_apb1() ? kNanoseconds1 : kNanoseconds2;
}

std::uint32_t counts(const PwmSetup& setup, std::uint32_t ns) {
  const std::uint32_t unit = nanoseconds(setup);
  return ns / unit * kCounts + ns % unit * kCounts / unit;
}

/// Counts of a nanosecond in parts of 2^32, rounded down.
constexpr std::uint32_t scale(std::uint32_t unit) {
  return static_cast<std::uint32_t>((std::uint64_t{kCounts} << 32) / unit);
}
static_assert(kCounts < kNanoseconds2 && kCounts < kNanoseconds1);

/// Prescaler and period of a repetition.
struct Division {
  std::uint32_t divider;  ///< the smallest with which the period fits 16 bits
  std::uint32_t top;      ///< counts of one repetition
};

Division divide(const PwmSetup& setup, std::uint32_t period) {
  const std::uint32_t total = counts(setup, period);
  const std::uint32_t divider = (total - 1) / 0x10000 + 1;
  return {divider, total / divider};
}

void remember(PwmHardware& hardware, const Division& division) {
  hardware.top = division.top;
  hardware.scale = (hardware.setup.is_on_apb1() ? scale(kNanoseconds1) : scale(kNanoseconds2)) / division.divider;
}

/// A channel has a byte of CCMR and a nibble of CCER, whose lowest bit turns the output on: RM0090 17.4.7, 17.4.9.
void turn_on(const PwmSetup& setup) {
  const std::uint32_t index = setup.channel - 1, shift = index % 2 * 8;
  setup.timer.ccmr(index / 2).modify(0xFFU << shift, timer::kPwmMode1 << shift);
  setup.timer.ccer().modify(0xFU << (index * 4), 1U << (index * 4));
}

}  // namespace

void PwmPort::start(Duration period) {
  const PwmSetup& setup = hardware_->setup;
  if (period < kShortestPwmPeriod || period > kLongestPwmPeriod) {
    stop_safely(Module::pwm, static_cast<std::uint8_t>(PwmFault::period), "a PWM period is out of range");
  }
  const Division division = divide(setup, static_cast<std::uint32_t>(period));
  const std::uint32_t divider = division.divider, top = division.top;

  rcc::enable(setup.is_on_apb1() ? rcc::apb1enr : rcc::apb2enr, setup.clock_bit);
  const bool running = setup.timer.cr1().any(timer::kCr1Enable);
  if (running && (setup.timer.psc().read() != divider - 1 || setup.timer.arr().read() != top - 1)) {
    stop_safely(Module::pwm, static_cast<std::uint8_t>(PwmFault::two_periods), "one timer, two PWM periods");
  }
  setup.timer.psc().write(divider - 1);
  setup.timer.arr().write(top - 1);
  setup.timer.ccr(setup.channel).write(0);
  turn_on(setup);
  if (!running) {
    if (setup.is_advanced()) setup.timer.bdtr().write(timer::kBdtrMainOutput);
    setup.timer.egr().write(timer::kEgrUpdate);  // loads prescaler and preloads
    setup.timer.cr1().write(timer::kCr1PreloadArr | timer::kCr1Enable);
  }
  remember(*hardware_, division);
  configure(setup.pin, stm32f4::PinSetup{stm32f4::PinMode::alternate, stm32f4::PinPull::down, false, setup.function});
}

bool PwmPort::tune(std::uint32_t period) {
  const PwmSetup& setup = hardware_->setup;
  const std::uint32_t own = 0xFU << ((setup.channel - 1) * 4);
  if (period < kShortestPwmPeriod || period > kLongestPwmPeriod || setup.timer.ccer().any(0xFFFFU & ~own)) return false;
  const Division division = divide(setup, period);
  setup.timer.psc().write(division.divider - 1);  // both are preloaded: next repetition
  setup.timer.arr().write(division.top - 1);
  remember(*hardware_, division);
  return true;
}

void PwmPort::write(std::uint32_t pulse) {
  const auto wanted = static_cast<std::uint32_t>((std::uint64_t{pulse} * hardware_->scale + (1U << 31)) >> 32);
  const std::uint32_t top = hardware_->top;
  const stm32f4::TimerRegisters& timer = hardware_->setup.timer;
  timer.ccr(hardware_->setup.channel).write(wanted < top ? wanted : top);  // preloaded: next repetition
  // What is safe after a reset is the first pulse, whatever the first job writes: the repetition begins anew with it.
  if (!cortex_m4::has_begun()) timer.egr().write(timer::kEgrUpdate);
}

}  // namespace finemote
