#include "spi_line.hpp"

#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace rcc = stm32f4::rcc;
namespace spi = stm32f4::spi;
using stm32f4::PinMode;
using stm32f4::PinPull;

/// A byte at the slowest clock takes 8 x 512 cycles of the core; ten times as much.
constexpr std::uint32_t kByteLimit = 10 * 8 * 512;

bool exchange_byte(const stm32f4::SpiRegisters& registers, std::uint8_t& byte) {
  registers.dr().write(byte);
  if (!wait_until(registers.sr(), spi::kReceived, spi::kReceived, kByteLimit)) return false;
  byte = static_cast<std::uint8_t>(registers.dr().read());
  return true;
}

}  // namespace

std::uint32_t spi_control(std::uint32_t divider) {
  constexpr std::uint32_t kMode3 = 3;
  return spi::kMaster | spi::kSelectBySoftware | spi::kSelectHigh | spi::kOn | divider << spi::kDividerShift | kMode3;
}

void start_spi(const SpiPins& port) {
  for (unsigned i = 0; i < port.select_count; ++i) {
    rcc::enable(rcc::ahb1enr, stm32f4::bit(static_cast<unsigned>(port.selects[i].port - 'A')));
    port.selects[i].set(true);
    stm32f4::configure(port.selects[i], {PinMode::output});
  }
  stm32f4::configure(port.sck, {PinMode::alternate, PinPull::up, false, port.function});
  stm32f4::configure(port.miso, {PinMode::alternate, PinPull::up, false, port.function});
  stm32f4::configure(port.mosi, {PinMode::alternate, PinPull::none, false, port.function});
  const stm32f4::SpiPeripheral& it = port.peripheral;
  rcc::enable(it.clock_enable, it.clock_bit);
  rcc::restart(it.clock_enable, it.clock_bit);
}

bool exchange(const SpiPins& port, unsigned select, std::uint8_t* bytes, unsigned size) {
  const stm32f4::SpiRegisters registers = port.peripheral.spi;
  registers.cr1().write(spi_control(kSpiDivider));
  port.selects[select].set(false);
  bool ok = true;
  for (unsigned i = 0; ok && i < size; ++i) ok = exchange_byte(registers, bytes[i]);
  ok = wait_until(registers.sr(), spi::kTransmitEmpty | spi::kBusy, spi::kTransmitEmpty, kByteLimit) && ok;
  port.selects[select].set(true);
  registers.cr1().clear(spi::kOn);
  return ok;
}

}  // namespace finemote::bench_kit
