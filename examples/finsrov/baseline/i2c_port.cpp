#include "i2c_port.hpp"

namespace baseline {

namespace {

using namespace finemote::stm32f4;

constexpr std::uint32_t kBusHz = 400'000;
constexpr finemote::Duration kHalfBit = 5 * finemote::kMicrosecond;
constexpr unsigned kMostClocks = 9;

}  // namespace

void set_up_i2c() {
  rcc::enable(rcc::apb1enr, kI2c2.clock_bit);
  const PinSetup pin{PinMode::alternate, PinPull::up, true, 4};
  configure(kScl, pin);
  configure(kSda, pin);
  kI2c.cr1().write(i2c::kSoftwareReset);
  kI2c.cr1().write(0);
  kI2c.cr2().write(kApb1Hz / 1'000'000);
  kI2c.ccr().write(i2c::kFastMode | (kApb1Hz + 3 * kBusHz - 1) / (3 * kBusHz));
  kI2c.trise().write(kApb1Hz / 1'000'000 * 300 / 1000 + 1);
  kI2c.cr1().write(i2c::kOn);
}

void free_i2c() {
  kI2c.cr1().write(0);
  kScl.set(true);
  kSda.set(true);
  const PinSetup by_hand{PinMode::output, PinPull::up, true, 0};
  configure(kScl, by_hand);
  configure(kSda, by_hand);
  for (unsigned clock = 0; clock < kMostClocks && !kSda.is_high(); ++clock) {
    kScl.set(false);
    wait_at_start(kHalfBit);
    kScl.set(true);
    wait_at_start(kHalfBit);
  }
  kScl.set(false);
  kSda.set(false);
  wait_at_start(kHalfBit);
  kScl.set(true);
  wait_at_start(kHalfBit);
  kSda.set(true);
  wait_at_start(kHalfBit);
  set_up_i2c();
}

void wait_at_start(finemote::Duration time) {
  const std::uint32_t from = finemote::cortex_m4::cycles();
  while (finemote::cortex_m4::cycles() - from < cycles_in(time)) {}
}

}  // namespace baseline
