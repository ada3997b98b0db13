// EdgePort on EXTI: RM0090 12.2; the port behind a line is chosen in SYSCFG, 9.2.3 to 9.2.6.
#include "finemote/loop_bound.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/urgent_interrupt.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/chips/stm32f4/ports/exti_hardware.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote {
namespace {

namespace exti = stm32f4::exti;
namespace rcc = stm32f4::rcc;
using stm32f4::PinPull;

constexpr std::uint8_t kPriority = cortex_m4::kBusPriority;

}  // namespace

void EdgePort::start(bool falling) {
  const stm32f4::Pin pin = hardware_->pin;
  configure(pin, stm32f4::PinSetup{stm32f4::PinMode::input, falling ? PinPull::up : PinPull::down});
  rcc::enable(rcc::apb2enr, rcc::kApb2Syscfg);
  const std::uint32_t shift = pin.number % 4U * 4, bit = stm32f4::bit(pin.number);
  stm32f4::syscfg::exticr(pin.number / 4U).modify(0xFU << shift, static_cast<std::uint32_t>(pin.port - 'A') << shift);
  (falling ? exti::ftsr : exti::rtsr).set(bit);
  (falling ? exti::rtsr : exti::ftsr).clear(bit);
  exti::pr.write(bit);
  exti::imr.set(bit);
  cortex_m4::enable_line(hardware_->line, kPriority);
}

// The interrupt may come between the two reads, then the count has changed: once more. It cannot come for ever: two
// edges closer than this loop would leave no time for anything.
Edge EdgePort::last() const {
  Edge edge;
  for (unsigned turn = 0; turn < 4; ++turn) {
    retried_if_interrupted<RetriedBy::event>();
    edge.count = hardware_->count.load();
    Shared<std::uint32_t>::fence();
    edge.at = hardware_->at;
    Shared<std::uint32_t>::fence();
    if (hardware_->count.load() == edge.count) break;
  }
  return edge;
}

bool EdgeHardware::is_pending() const { return exti::pr.any(stm32f4::bit(pin.number)); }

void EdgeHardware::on_interrupt() {
  const cortex_m4::UrgentInterrupt interrupt;
  exti::pr.write(stm32f4::bit(pin.number));  // rc_w1: 12.3.6
  at = interrupt.event().earliest;
  Shared<std::uint32_t>::fence();
  count.store(count.load() + 1);
  stm32f4::settle(exti::pr);
}

}  // namespace finemote
