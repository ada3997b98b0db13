#include "i2c_line.hpp"

#include "bench_plan.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "stopwatch.hpp"

namespace finemote::bench_kit {
namespace {

namespace i2c = stm32f4::i2c;
namespace rcc = stm32f4::rcc;
using stm32f4::PinMode;
using stm32f4::PinPull;

constexpr std::uint32_t kEventLimit = cycles_in(2'000);
// Fast mode with a low phase of two thirds: three counts a bit; a rise may take 300 ns. RM0090 27.6.8, 27.6.9.
constexpr std::uint32_t kRateHz = 400'000, kBusMHz = stm32f4::kApb1Hz / 1'000'000;
constexpr std::uint32_t kCount = stm32f4::kApb1Hz / (3 * kRateHz), kRise = kBusMHz * 300 / 1'000 + 1;

constexpr stm32f4::I2cRegisters kRegisters = kSensorI2c.peripheral.i2c;

bool comes(std::uint32_t event) {
  const Stopwatch watch;
  while (!kRegisters.sr1().any(event)) {
    if (kRegisters.sr1().any(i2c::kErrors) || watch.has_passed(kEventLimit)) return false;
  }
  return true;
}

void stop() { kRegisters.cr1().set(i2c::kStop); }

/// Until the STOP is on the wire; the flag falls with it.
bool stops() { return wait_until(kRegisters.cr1(), i2c::kStop, 0, kEventLimit); }

/// START and address; ADDR stays set. @return false: nobody acknowledged, and the STOP was sent
bool call(std::uint8_t part, bool reads) {
  kRegisters.cr1().set(i2c::kStart);
  if (!comes(i2c::kStartSent)) return false;
  kRegisters.dr().write(static_cast<std::uint32_t>(part) << 1 | (reads ? 1U : 0U));
  if (comes(i2c::kAddressSent)) return true;
  kRegisters.sr1().clear(i2c::kNoAcknowledge);
  stop();
  static_cast<void>(stops());
  return false;
}

void clear_address() { static_cast<void>(kRegisters.sr2().read()); }

/// Of the only byte to come: RM0090 27.3.3, master receiver.
void end_at_address() {
  clear_address();
  stop();
}

void end_masked() {
  const cortex_m4::Masked masked;
  end_at_address();
}

/// Says which register is meant.
bool point_at(std::uint8_t part, std::uint8_t address) {
  if (!call(part, false)) return false;
  clear_address();
  kRegisters.dr().write(address);
  return comes(i2c::kByteFinished);
}

}  // namespace

void start_i2c() {
  stm32f4::configure(kSensorI2c.scl, {PinMode::alternate, PinPull::up, true, kSensorI2c.function});
  stm32f4::configure(kSensorI2c.sda, {PinMode::alternate, PinPull::up, true, kSensorI2c.function});
  const std::uint32_t clock = kSensorI2c.peripheral.clock_bit;
  rcc::enable(rcc::apb1enr, clock);
  rcc::restart(rcc::apb1enr, clock);
  kRegisters.cr2().write(kBusMHz);
  kRegisters.ccr().write(i2c::kFastMode | kCount);
  kRegisters.trise().write(kRise);
  kRegisters.cr1().write(i2c::kOn);
}

Reading read_register(std::uint8_t part, std::uint8_t address, Interrupts interrupts) {
  Reading result;
  if (!point_at(part, address) || !call(part, true)) return result;
  kRegisters.cr1().clear(i2c::kAcknowledge);
  interrupts == Interrupts::masked ? end_masked() : end_at_address();
  result.is_late = kRegisters.sr1().any(i2c::kReceived);
  if (!comes(i2c::kReceived)) return result;
  const Stopwatch watch;
  result.byte = static_cast<std::uint8_t>(kRegisters.dr().read());
  result.came = stops();
  result.stop_cycles = watch.cycles();
  return result;
}

std::uint32_t time_bytes(std::uint8_t part, std::uint8_t address, unsigned count) {
  kRegisters.cr1().set(i2c::kAcknowledge);
  if (!point_at(part, address) || !call(part, true)) return 0;
  clear_address();
  Stopwatch first;
  std::uint32_t last = 0;
  for (unsigned i = 0; i < count; ++i) {
    if (!comes(i2c::kReceived)) return 0;
    if (i == 0) first = Stopwatch();
    last = first.cycles();
    if (i + 2 == count) {
      kRegisters.cr1().clear(i2c::kAcknowledge);
      stop();
    }
    static_cast<void>(kRegisters.dr().read());
  }
  return stops() ? last : 0;
}

}  // namespace finemote::bench_kit
