#include "uart_line.hpp"

#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote::bench_kit {

void start_uart(const UartPins& port, std::uint32_t bus_hz, std::uint32_t parts_on) {
  namespace usart = stm32f4::usart;
  const stm32f4::PinSetup pin{stm32f4::PinMode::alternate, stm32f4::PinPull::up, false, port.function};
  const stm32f4::UsartPeripheral& it = port.peripheral;
  if ((parts_on & usart::kReceiverOn) != 0) stm32f4::configure(port.rx, pin);
  if ((parts_on & usart::kTransmitterOn) != 0) stm32f4::configure(port.tx, pin);
  stm32f4::rcc::enable(it.clock_enable, it.clock_bit);
  stm32f4::rcc::restart(it.clock_enable, it.clock_bit);            // the robot may have used it
  it.usart.brr().write((bus_hz + kReportBaud / 2) / kReportBaud);  // in sixteenths of 16: RM0090 30.3.4
  it.usart.cr1().write(usart::kOn | parts_on);
}

}  // namespace finemote::bench_kit
