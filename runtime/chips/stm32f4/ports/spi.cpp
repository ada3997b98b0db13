// SpiPort on the chip's SPI as master, by DMA both ways or by one interrupt per byte. Procedures:
// RM0090 28.3.5, 28.3.8, 28.3.9.
#include "finemote/spi.hpp"

#include "finemote/fault.hpp"
#include "finemote/four_bytes.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/chips/stm32f4/ports/spi_hardware.hpp"
#include "runtime/chips/stm32f4/ports/stop_stream.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/wait.hpp"

namespace finemote {
namespace {

namespace dma = stm32f4::dma;
namespace rcc = stm32f4::rcc;
namespace spi = stm32f4::spi;
using stm32f4::kSpiCopy;
using stm32f4::Pin;
using stm32f4::PinMode;
using stm32f4::PinPull;
using stm32f4::PinSetup;
using stm32f4::SpiSetup;

enum class SpiFault : std::uint8_t {
  dma_stuck = 16,  ///< a stream did not stop
  busy,            ///< the last clock edge did not come
};

constexpr std::uint8_t kPriority = cortex_m4::kSlowBusPriority;
constexpr std::uint32_t kSlowest = 7, kCyclesPerUs = cortex_m4::kCoreHz / 1'000'000;

/// For how long the end of the clock is waited for. The last bit is sampled (RM0090 28.3.3, figure 248): of its clock
/// half a period is left at most, and BSY falls with the period's end. A bit is waited for, and half a microsecond
/// until the flag shows it: synchronising takes a few clocks of the bus. Nobody but the master makes the clock.
std::uint32_t busy_limit(std::uint32_t clock_hz, std::uint32_t divider) {
  return (cortex_m4::kCoreHz / clock_hz << (divider + 1)) + kCyclesPerUs / 2;
}

std::uint32_t address_of(const void* bytes) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes));
}

/// DMA reaches neither the core-coupled RAM at 0x10000000 nor what stands at 0, as code in SRAM does: RM0090 2.1, 2.4.
bool dma_reaches(const void* bytes) {
  constexpr std::uint32_t kFlash = 0x08000000;
  const std::uint32_t address = address_of(bytes);
  return address >> 28 != 1 && address >= kFlash;
}

/// The smallest divider 2 << n whose clock is not above the wanted one.
std::uint32_t divider_for(std::uint32_t clock_hz, std::uint32_t wanted_hz) {
  std::uint32_t n = 0;
  while (n < kSlowest && (clock_hz >> (n + 1)) > wanted_hz) ++n;
  return n;
}

void stop_stream(const stm32f4::DmaStream& stream) {
  if (!stm32f4::stop(stream)) count_fault(Module::spi, static_cast<std::uint8_t>(SpiFault::dma_stuck));
}

/// The end of the exchange before has stopped it.
void start_stream(const stm32f4::DmaStream& stream, std::uint32_t peripheral, const void* memory, std::uint32_t count,
                  std::uint32_t control) {
  if (stream.cr().any(dma::kEnable)) {
    only_after_fault();  // dma_stuck
    stop_stream(stream);
  }
  stream.par().write(peripheral);
  stream.m0ar().write(address_of(memory));
  stream.ndtr().write(count);
  stream.cr().write(control | dma::kEnable);
}

}  // namespace

void SpiPort::configure(std::int64_t clock_hz, SpiBus& bus) {
  const SpiSetup& setup = hardware_->setup;
  hardware_->bus.set(&bus);
  for (unsigned i = 0; i < setup.select_count; ++i) {
    rcc::enable(rcc::ahb1enr, stm32f4::bit(static_cast<unsigned>(setup.selects[i].port - 'A')));
    setup.selects[i].set(true);
    stm32f4::configure(setup.selects[i], PinSetup{PinMode::output});
  }
  // The clock has a level of its own while the peripheral is off and does not drive it.
  stm32f4::configure(setup.sck, PinSetup{PinMode::alternate, PinPull::up, false, setup.function});
  stm32f4::configure(setup.miso, PinSetup{PinMode::alternate, PinPull::none, false, setup.function});
  stm32f4::configure(setup.mosi, PinSetup{PinMode::alternate, PinPull::none, false, setup.function});
  rcc::enable(setup.clock_enable, setup.clock_bit);
  if (setup.dma) {
    rcc::enable(rcc::ahb1enr, setup.receive.controller == dma::kController1 ? rcc::kAhb1Dma1 : rcc::kAhb1Dma2);
  }
  hardware_->divider = divider_for(setup.clock_hz, static_cast<std::uint32_t>(clock_hz));
  hardware_->busy_limit.set(busy_limit(setup.clock_hz, hardware_->divider));
  cortex_m4::enable_line(setup.line, kPriority);
}

void SpiPort::pend() { stm32f4::pend_line(hardware_->setup.line); }

std::uint16_t SpiPort::moved() const { return hardware_->moved; }

void SpiPort::begin(const SpiMessage& message) {
  const SpiSetup& setup = hardware_->setup;
  hardware_->message = message;
  hardware_->moved = 0;
  hardware_->active = true;
  const std::uint32_t control = spi::kMaster | spi::kSelectBySoftware | spi::kSelectHigh |
                                hardware_->divider << spi::kDividerShift | (message.mode & 3U);
  setup.spi.cr1().write(control);  // mode and clock only change while it is off
  setup.spi.cr2().write(setup.dma ? 0 : spi::kReceiveInterrupt);
  static_cast<void>(setup.spi.dr().read());
  static_cast<void>(setup.spi.sr().read());  // forgets an overrun: RM0090 28.3.10
  setup.spi.cr1().write(control | spi::kOn);
  if (message.select < setup.select_count) setup.selects[message.select].set(false);
  if (setup.dma) {
    hardware_->start_dma();
  } else {
    hardware_->next_byte();
  }
}

void SpiPort::abort() {
  hardware_->active = false;
  hardware_->reset();
}

void SpiHardware::release_bus() const {
  for (unsigned i = 0; i < setup.select_count; ++i) setup.selects[i].set(true);
  setup.spi.cr2().write(0);
}

/// The end of an exchange, RM0090 28.3.8: the last byte is in, with which the streams have turned themselves off; what
/// is left is the last edge of the clock.
void SpiHardware::stop() const {
  constexpr std::uint32_t kIdle = spi::kTransmitEmpty;
  if (!stm32f4::wait_within(setup.spi.sr(), spi::kTransmitEmpty | spi::kBusy, kIdle, cortex_m4::cycles(), busy_limit)) {
    count_fault(Module::spi, static_cast<std::uint8_t>(SpiFault::busy));
    return reset();
  }
  if (setup.dma) {
    setup.transmit.clear_flags(dma::kFlagsAll);
    setup.receive.clear_flags(dma::kFlagsAll);
  }
  release_bus();
  setup.spi.cr1().clear(spi::kOn);
}

/// An end at any moment: turned off, the peripheral may keep a byte that the next exchange would send first. Only its
/// reset makes sure that it does not.
void SpiHardware::reset() const {
  only_after_fault();
  if (setup.dma) {
    stop_stream(setup.transmit);
    stop_stream(setup.receive);
  }
  release_bus();
  const cortex_m4::Masked masked;  // other ports share the register
  rcc::restart(setup.clock_enable, setup.clock_bit);
}

/// Receiving is started before sending, so that no byte is missed: RM0090 28.3.9.
void SpiHardware::start_dma() {
  const std::uint32_t size = message.size, channel = std::uint32_t{setup.channel} << dma::kChannelShift;
  const std::uint8_t* out = message.write;
  std::uint8_t* in = message.read;
  if (out != nullptr && !dma_reaches(out) && size <= kSpiCopy) {
    move_bytes(out, buffers.out, size);
    out = buffers.out;
  }
  if (in != nullptr && !dma_reaches(in) && size <= kSpiCopy) in = buffers.in;
  buffers.ones = 0xFF;
  const std::uint32_t data = setup.spi.dr().address();
  start_stream(setup.receive, data, in != nullptr ? in : &buffers.dropped, size,
               channel | dma::kPriorityHigh | (in != nullptr ? dma::kMemoryIncrement : 0) | dma::kCompleteInterrupt |
                   dma::kErrorInterrupt);
  start_stream(setup.transmit, data, out != nullptr ? out : &buffers.ones, size,
               channel | (out != nullptr ? dma::kMemoryIncrement : 0) | dma::kMemoryToPeripheral);
  setup.spi.cr2().write(spi::kDmaReceive | spi::kDmaTransmit);
}

void SpiHardware::next_byte() { setup.spi.dr().write(message.write != nullptr ? message.write[moved] : 0xFFU); }

SpiEvent SpiHardware::finish(SpiEvent event) {
  only_if_raised_by<Raised::end>();
  active = false;
  event == SpiEvent::kDone ? stop() : reset();
  return event;
}

SpiEvent SpiHardware::step_dma() {
  const std::uint32_t flags = setup.receive.flags();
  if ((flags & dma::kFlagError) != 0) return finish(SpiEvent::kError);
  if ((flags & dma::kFlagComplete) == 0) return SpiEvent::kNone;
  const bool copied = message.read != nullptr && !dma_reaches(message.read);
  const SpiEvent event = finish(SpiEvent::kDone);
  const std::size_t size = message.size;
  if (copied && size > kSpiCopy) return SpiEvent::kError;
  if (copied) move_bytes(buffers.in, message.read, size);
  return event;
}

SpiEvent SpiHardware::step_byte() {
  const std::uint32_t status = setup.spi.sr().read();
  if ((status & spi::kOverrun) != 0) return finish(SpiEvent::kError);
  if ((status & spi::kReceived) == 0) return SpiEvent::kNone;
  only_if_raised_by<Raised::step, Raised::end>();
  const auto byte = static_cast<std::uint8_t>(setup.spi.dr().read());
  if (message.read != nullptr) message.read[moved] = byte;
  if (++moved == message.size) return finish(SpiEvent::kDone);
  next_byte();
  return SpiEvent::kNone;
}

void SpiHardware::on_line() {
  SpiEvent event = SpiEvent::kNone;
  if (active) event = setup.dma ? step_dma() : step_byte();
  bus->on_interrupt(event);
  stm32f4::settle(setup.spi.cr1());
}

}  // namespace finemote
