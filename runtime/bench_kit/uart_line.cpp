#include "uart_line.hpp"

#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote::bench_kit {

void start_uart(const UartPins& port, std::uint32_t parts_on) {
  namespace usart = stm32f4::usart;
  using stm32f4::PinMode;
  using stm32f4::PinPull;
  const stm32f4::UsartRegisters registers = port.peripheral.usart;
  stm32f4::configure(port.rx, {PinMode::alternate, PinPull::up, false, port.function});
  if ((parts_on & usart::kTransmitterOn) != 0)
    stm32f4::configure(port.tx, {PinMode::alternate, PinPull::up, false, port.function});
  stm32f4::rcc::enable(port.peripheral.clock_enable, port.peripheral.clock_bit);
  registers.cr1().write(0);
  registers.brr().write((port.peripheral.clock_hz + kReportBaud / 2) / kReportBaud);  // sixteenths of 16: RM0090 30.3.4
  registers.cr1().write(usart::kOn | parts_on);
}

}  // namespace finemote::bench_kit
