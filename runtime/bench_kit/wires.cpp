// Wire times: what is sent has to come back, at the rate that the port's clock and divider make. I2C asks the part on
// the board, CAN loops back inside, the others need a jumper from an output to the input.
#include "can_line.hpp"
#include "groups.hpp"
#include "i2c_line.hpp"
#include "record.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "spi_line.hpp"
#include "stopwatch.hpp"
#include "uart_line.hpp"

namespace finemote::bench_kit {
namespace {

namespace spi = stm32f4::spi;
namespace usart = stm32f4::usart;

constexpr std::uint32_t kBytes = 32;
constexpr std::uint32_t kLimit = cycles_in(5'000);

/// Nothing that an idle line or a stuck one could bring.
constexpr std::uint8_t pattern(std::uint32_t i) { return static_cast<std::uint8_t>(0x35 + 7 * i); }

struct Returned {
  std::uint32_t bytes = 0, wrong = 0;
  std::uint32_t first = 0, last = 0;  ///< when they came [cycles]

  void take(std::uint8_t byte, std::uint32_t at) {
    if (bytes == 0) first = at;
    last = at;
    wrong += byte == pattern(bytes++) ? 0 : 1;
  }
  /// From one to the next.
  [[nodiscard]] std::uint32_t byte_ns() const { return ns_of((last - first) / (kBytes - 1)); }
};

/// Sends the pattern without a pause, and takes what comes. @return when all of it has come, or nothing more does
Returned send_round(const stm32f4::Register& status, const stm32f4::Register& data, std::uint32_t ready,
                    std::uint32_t came) {
  Returned returned;
  std::uint32_t sent = 0;
  for (const Stopwatch watch; returned.bytes < kBytes && !watch.has_passed(kLimit);) {
    const std::uint32_t flags = status.read();
    if ((flags & came) != 0) returned.take(static_cast<std::uint8_t>(data.read()), watch.cycles());
    if ((flags & ready) != 0 && sent < kBytes) data.write(pattern(sent++));
  }
  return returned;
}

void record(const Returned& returned, Test byte_ns, Test wrong_bytes) {
  if (returned.bytes < kBytes || returned.wrong == kBytes) {
    miss(byte_ns, Missing::partner);
    return miss(wrong_bytes, Missing::partner);
  }
  put(byte_ns, returned.byte_ns());
  put(wrong_bytes, returned.wrong);
}

}  // namespace

void measure_i2c_wire() {
  constexpr std::uint8_t kPart = 0x0E, kFirst = 0x00;
  start_i2c();
  const std::uint32_t cycles = time_bytes(kPart, kFirst, kBytes);
  if (cycles == 0) return miss(Test::wire_i2c_byte_ns, Missing::answer);
  put(Test::wire_i2c_byte_ns, ns_of(cycles / (kBytes - 1)));
}

void measure_can_wire() {
  const CanLoop loop = send_to_itself();
  if (!loop.came) {
    miss(Test::wire_can_frame_ns, Missing::answer);
    return miss(Test::wire_can_wrong_frames, Missing::answer);
  }
  put(Test::wire_can_frame_ns, ns_of(loop.cycles));
  put(Test::wire_can_wrong_frames, loop.wrong);
}

void measure_serial_wire() {
  start_uart(kLoopUart, kLoopUart.peripheral.clock_hz, usart::kTransmitterOn | usart::kReceiverOn);
  const stm32f4::UsartRegisters registers = kLoopUart.peripheral.usart;
  record(send_round(registers.sr(), registers.dr(), usart::kTransmitEmpty, usart::kReceived), Test::wire_serial_byte_ns,
         Test::wire_serial_wrong_bytes);
  registers.cr1().write(0);
}

void measure_spi_wire() {
  start_spi(kLoopSpi);
  const stm32f4::SpiRegisters registers = kLoopSpi.peripheral.spi;
  registers.cr1().write(spi_control(kSpiDivider));
  kLoopSpi.selects[0].set(false);
  const Returned returned = send_round(registers.sr(), registers.dr(), spi::kTransmitEmpty, spi::kReceived);
  static_cast<void>(wait_until(registers.sr(), spi::kBusy, 0, kLimit));
  kLoopSpi.selects[0].set(true);
  registers.cr1().clear(spi::kOn);
  record(returned, Test::wire_spi_byte_ns, Test::wire_spi_wrong_bytes);
}

}  // namespace finemote::bench_kit
