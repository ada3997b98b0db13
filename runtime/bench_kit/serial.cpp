// The serial ports: what a receiver hears that nobody sends to.
#include "groups.hpp"
#include "record.hpp"
#include "stopwatch.hpp"
#include "uart_line.hpp"

namespace finemote::bench_kit {
namespace {

namespace usart = stm32f4::usart;
constexpr std::uint32_t kByteUs = 87;  ///< ten bits

/// Turns the receiver on and listens for five bytes' time. @return bytes heard
std::uint32_t listen(const UartPins& port) {
  constexpr std::uint32_t kListenUs = 5 * kByteUs;
  const stm32f4::UsartRegisters registers = port.peripheral.usart;
  start_uart(port, port.peripheral.clock_hz, usart::kReceiverOn);
  std::uint32_t heard = 0;
  for (const Stopwatch watch; !watch.has_passed(cycles_in(kListenUs));) {
    if (!registers.sr().any(usart::kReceived | usart::kErrors)) continue;
    static_cast<void>(registers.dr().read());
    ++heard;
  }
  registers.cr1().write(0);
  return heard;
}

}  // namespace

void listen_to_silence() {
  constexpr unsigned kRounds = 8;
  std::uint32_t heard = 0;
  for (const UartPins& port : kSerialPorts) {
    for (unsigned i = 0; i < kRounds; ++i) heard += listen(port);
  }
  put(Test::serial_bytes_of_noise, heard);
}

}  // namespace finemote::bench_kit
