// What the manual leaves open, or reads as if it happened at once: DMA, SPI, I2C and CAN, watched by polling. A driver
// that relies on it works until it meets a chip that is otherwise.
#include "can_line.hpp"
#include "groups.hpp"
#include "i2c_line.hpp"
#include "record.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/registers/dma.hpp"
#include "spi_line.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace dma = stm32f4::dma;
namespace rcc = stm32f4::rcc;
namespace spi = stm32f4::spi;

constexpr stm32f4::SpiRegisters kSpi = kSensorSpi.peripheral.spi;
constexpr std::uint32_t kSlowest = 7, kByteUs = 25;  ///< 8 bits at 84 MHz / 256
constexpr std::uint32_t kLimit = cycles_in(1'000);

/// From the last byte to the end of the clock, as BSY shows it.
std::uint32_t time_busy() {
  kSpi.cr1().write(spi_control(kSlowest));
  kSpi.dr().write(0xFF);
  if (!wait_until(kSpi.sr(), spi::kReceived, spi::kReceived, kLimit)) return kLimit;
  const Stopwatch watch;
  static_cast<void>(wait_until(kSpi.sr(), spi::kBusy, 0, kLimit));
  const std::uint32_t cycles = watch.cycles();
  static_cast<void>(kSpi.dr().read());
  return cycles;
}

/// Turns the SPI off with a byte waiting behind the one that is sent, and on again. @return whether something came then
bool keeps_byte() {
  start_spi(kSensorSpi);
  kSpi.cr1().write(spi_control(kSlowest));
  kSpi.dr().write(0xFF);
  static_cast<void>(wait_until(kSpi.sr(), spi::kTransmitEmpty, spi::kTransmitEmpty, kLimit));
  kSpi.dr().write(0xFF);
  kSpi.cr1().clear(spi::kOn);
  static_cast<void>(kSpi.dr().read());
  kSpi.cr1().set(spi::kOn);
  return wait_until(kSpi.sr(), spi::kReceived, spi::kReceived, cycles_in(3 * kByteUs));
}

constexpr std::uint32_t kBytes = 64;
std::uint8_t received[kBytes];
const std::uint8_t kOnes = 0xFF;

std::uint32_t address_of(const void* bytes) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes));
}

void start_stream(const stm32f4::DmaStream& stream, const void* memory, std::uint32_t control) {
  stream.cr().clear(dma::kEnable);
  static_cast<void>(wait_until(stream.cr(), dma::kEnable, 0, kLimit));
  stream.clear_flags(dma::kFlagsAll);
  stream.par().write(kSpi.dr().address());
  stream.m0ar().write(address_of(memory));
  stream.ndtr().write(kBytes);
  stream.cr().write(kSensorSpi.request << dma::kChannelShift | control | dma::kEnable);
}

/// Receives ones, for nobody is selected and the line is pulled up, into a buffer of zeros.
void start_exchange() {
  for (volatile std::uint8_t& byte : received) byte = 0;
  rcc::enable(rcc::ahb1enr, rcc::kAhb1Dma1 | rcc::kAhb1Dma2);
  kSpi.cr1().write(spi_control(kSpiDivider));
  start_stream(kSensorSpi.receive, received, dma::kPriorityHigh | dma::kMemoryIncrement);
  start_stream(kSensorSpi.transmit, &kOnes, dma::kMemoryToPeripheral);
  kSpi.cr2().write(spi::kDmaReceive | spi::kDmaTransmit);
}

struct Behind {
  std::uint32_t bytes = 0;  ///< that were counted before they were in memory
  bool flag = false;        ///< the flag of the end came after the last count
  bool is_complete = false;
};

/// Looks into memory whenever the stream has counted a byte, and at the flag when it has counted all.
Behind watch_exchange() {
  const stm32f4::DmaStream& stream = kSensorSpi.receive;
  const volatile std::uint8_t* const bytes = received;
  Behind behind;
  start_exchange();
  const Stopwatch watch;
  for (std::uint32_t seen = kBytes; seen != 0 && !watch.has_passed(kLimit);) {
    const std::uint32_t left = stream.ndtr().read();
    if (left == seen) continue;
    const bool is_there = bytes[kBytes - 1 - left] != 0;
    if (left == 0) behind.flag = (stream.flags() & dma::kFlagComplete) == 0;
    if (!is_there) ++behind.bytes;
    seen = left;
  }
  behind.is_complete = wait_until(kSpi.sr(), spi::kBusy, 0, kLimit) && stream.ndtr().read() == 0;
  kSpi.cr2().write(0);
  kSpi.cr1().clear(spi::kOn);
  return behind;
}

void count_behind() {
  constexpr unsigned kRounds = 16;
  std::uint32_t bytes = 0, flags = 0;
  for (unsigned i = 0; i < kRounds; ++i) {
    const Behind behind = watch_exchange();
    if (!behind.is_complete) {
      miss(Test::dma_bytes_behind_count, Missing::answer);
      return miss(Test::dma_flags_behind_count, Missing::answer);
    }
    bytes += behind.bytes;
    flags += behind.flag ? 1 : 0;
  }
  put(Test::dma_bytes_behind_count, bytes);
  put(Test::dma_flags_behind_count, flags);
}

}  // namespace

void watch_spi() {
  constexpr unsigned kRounds = 16;
  start_spi(kSensorSpi);
  for (unsigned i = 0; i < kRounds; ++i) put_largest(Test::spi_busy_after_last_byte_ns, ns_of(time_busy()));
  std::uint32_t kept = 0;
  for (unsigned i = 0; i < kRounds; ++i) kept += keeps_byte() ? 1 : 0;
  put(Test::spi_bytes_kept, kept);
  start_spi(kSensorSpi);
  count_behind();
  start_spi(kSensorSpi);
}

void watch_i2c() {
  constexpr std::uint8_t kAddress = 0x0E, kWhoAmI = 0x00;
  constexpr unsigned kRounds = 32;
  start_i2c();
  std::uint32_t late = 0;
  for (unsigned i = 0; i < kRounds; ++i) {
    const Reading found = read_register(kAddress, kWhoAmI, Interrupts::allowed);
    if (!found.came) {
      miss(Test::i2c_stop_ns, Missing::answer);
      return miss(Test::i2c_late_stops, Missing::answer);
    }
    late += found.is_late ? 1 : 0;
    put_largest(Test::i2c_stop_ns, ns_of(found.stop_cycles));
  }
  put(Test::i2c_late_stops, late);
}

void watch_can() {
  constexpr unsigned kRounds = 8;
  for (unsigned i = 0; i < kRounds; ++i) {
    const CanStart start = enter_initialisation();
    if (!start.came) return miss(Test::can_initialisation_ns, Missing::answer);
    put_largest(Test::can_initialisation_ns, ns_of(start.cycles));
  }
}

}  // namespace finemote::bench_kit
