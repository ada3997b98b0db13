#include "can_line.hpp"

#include "runtime/chips/stm32f4/peripherals.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {

CanStart enter_initialisation() {
  namespace can = stm32f4::can;
  namespace rcc = stm32f4::rcc;
  constexpr std::uint32_t kLimit = cycles_in(50'000);
  const stm32f4::CanPeripheral& it = stm32f4::kCan1;
  rcc::enable(rcc::apb1enr, it.clock_bits);
  rcc::apb1rstr.set(it.clock_bits);
  rcc::apb1rstr.clear(it.clock_bits);
  const Stopwatch watch;
  it.can.mcr().modify(can::kSleepRequest, can::kInitRequest);
  CanStart start;
  start.came = wait_until(it.can.msr(), can::kInitAcknowledge, can::kInitAcknowledge, kLimit);
  start.cycles = watch.cycles();
  rcc::apb1rstr.set(it.clock_bits);
  rcc::apb1rstr.clear(it.clock_bits);
  return start;
}

}  // namespace finemote::bench_kit
