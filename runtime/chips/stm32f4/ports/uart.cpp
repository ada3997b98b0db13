// UartPort on a USART with two DMA streams. Procedures: RM0090 30.3.13 (continuous communication by DMA), 10.3.17.
#include "finemote/fault.hpp"
#include "finemote/loop_bound.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/urgent_interrupt.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/chips/stm32f4/ports/stop_stream.hpp"
#include "runtime/chips/stm32f4/ports/uart_hardware.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"

namespace finemote {
namespace {

namespace usart = stm32f4::usart;
namespace dma = stm32f4::dma;
namespace rcc = stm32f4::rcc;
using stm32f4::kUartTransmit;
using stm32f4::UartSetup;

enum class UartFault : std::uint8_t {
  inverted = 16,  ///< an inverted format on a port without inverter: the chip cannot invert
  dma_stuck,      ///< a stream did not stop
};

constexpr std::uint8_t kPriority = cortex_m4::kBusPriority;

/// The DMA counts a byte when it has read it, and memory has it later. Nobody gives a figure; taken as 64 cycles: seven
/// other streams of the controller come first (AN4031 2.1), eight cycles each. A turn of the wait takes at least three.
constexpr std::uint32_t kStoreTurns = 22;

/// Of CR1: of the line, but for damaged bytes, which CR3 has.
constexpr std::uint32_t kEventInterrupts = usart::kIdleInterrupt | usart::kParityInterrupt;
/// CR3 without them.
constexpr std::uint32_t kByDma = usart::kDmaReceive | usart::kDmaTransmit;

bool is_inverted(UartFormat format) { return format == UartFormat::k8E1Inverted || format == UartFormat::k8E2Inverted; }

/// CR1 bits of a format: with parity the word has nine bits, the ninth being the parity (RM0090 30.6.4).
std::uint32_t word_bits(UartFormat format) {
  return format == UartFormat::k8N1 ? 0 : usart::kNineBits | usart::kParityOn;
}

std::uint32_t stop_bits(UartFormat format) {
  return format == UartFormat::k8E2 || format == UartFormat::k8E2Inverted ? usart::kTwoStopBits : 0;
}

void stop_stream(const stm32f4::DmaStream& stream) {
  if (!stm32f4::stop(stream)) count_fault(Module::uart, static_cast<std::uint8_t>(UartFault::dma_stuck));
}

std::uint32_t address_of(const std::uint8_t* bytes) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes));
}

/// Receives into the ring for ever: circular mode, RM0090 10.3.8; an interrupt at the end of each lap.
/// The stream is off.
void start_receive(const UartSetup& setup, const UartRing& ring) {
  setup.receive.par().write(setup.usart.dr().address());
  setup.receive.m0ar().write(address_of(ring.bytes));
  setup.receive.ndtr().write(ring.size);
  setup.receive.cr().write(std::uint32_t{setup.channel} << dma::kChannelShift | dma::kPriorityHigh |
                           dma::kMemoryIncrement | dma::kCircular | dma::kCompleteInterrupt | dma::kErrorInterrupt |
                           dma::kEnable);
}

}  // namespace

void UartPort::start(std::int64_t baud, UartFormat format, UartRing ring) {
  const UartSetup& setup = hardware_->setup;
  if (is_inverted(format) && !setup.inverter) {
    stop_safely(Module::uart, static_cast<std::uint8_t>(UartFault::inverted), "this port cannot invert its line");
  }
  using stm32f4::PinMode;
  using stm32f4::PinPull;
  using stm32f4::PinSetup;
  configure(setup.tx, PinSetup{PinMode::alternate, PinPull::up, false, setup.function});
  configure(setup.rx, PinSetup{PinMode::alternate, PinPull::up, false, setup.function});
  rcc::enable(setup.clock_enable, setup.clock_bit);
  rcc::enable(rcc::ahb1enr, setup.receive.controller == dma::kController1 ? rcc::kAhb1Dma1 : rcc::kAhb1Dma2);

  const auto rate = static_cast<std::uint32_t>(baud);
  setup.usart.brr().write((setup.clock_hz + rate / 2) / rate);  // sixteenths of the divider: RM0090 30.3.4
  setup.usart.cr2().write(stop_bits(format));
  setup.usart.cr3().write(kByDma);
  hardware_->ring = ring;
  stop_stream(setup.receive);
  start_receive(setup, ring);
  setup.usart.cr1().write(usart::kOn | usart::kTransmitterOn | usart::kReceiverOn | word_bits(format));
  cortex_m4::enable_line(setup.usart_line, kPriority);
  cortex_m4::enable_line(setup.receive_line, kPriority);
}

// What is left is set only while events interrupt, or before they do: it never drops to 0 unseen. One that ends between
// the look and the store stays quiet until the next call, and so does a line on which something came meanwhile: what it
// ended by would be stamped late.
void UartPort::allow_events(std::uint32_t count) {
  const bool resumes = hardware_->quiet.load();
  hardware_->events_left.store(count);
  if (!resumes || count == 0) return;
  const std::uint32_t laps = hardware_->laps.load(), bytes = received(), size = hardware_->ring.size;
  const stm32f4::UsartRegisters& registers = hardware_->setup.usart;
  const stm32f4::Register left = hardware_->setup.receive.ndtr(), cr1 = registers.cr1(), cr3 = registers.cr3();
  const cortex_m4::Masked masked;  // an event in between would be stamped late, or turn them off again
  if (hardware_->laps.load() != laps || left.read() != size - (bytes & (size - 1))) return;
  hardware_->resumed_from = bytes;
  hardware_->quiet.store(false);
  cr1.set(kEventInterrupts);
  cr3.write(kByDma | usart::kErrorInterrupt);
}

std::uint32_t UartPort::received() const {
  const std::uint32_t before = hardware_->counted.load();
  const std::uint32_t count = hardware_->count();
  if (count != before) cortex_m4::spin(kStoreTurns);
  return count;
}

UartSeen UartPort::seen() const {
  UartSeen seen;
  const std::uint32_t before = hardware_->counted.load();
  seen.received = hardware_->count(&seen.idle);
  if (seen.received != before) cortex_m4::spin(kStoreTurns);
  return seen;
}

std::uint32_t UartHardware::count(UartIdle* idle) {
  const std::uint32_t before = counted.load();  // what is read from now on is no less
  const RingPlace place = ring_place(idle);
  return forward(before, place.laps * ring.size + place.position);
}

/// The routine that counts a lap is kept out. Where the flag comes up between its two reads, the lap ended within them:
/// the position is one of the last before or of the first behind. A second lap needs a whole ring of more bytes.
UartHardware::RingPlace UartHardware::ring_place(UartIdle* idle_now) const {
  const stm32f4::DmaStream& stream = setup.receive;
  const stm32f4::Register status = stream.status(), ndtr = stream.ndtr();
  std::uint32_t before = 0, left = 0, after = 0, full = 0;
  {
    const cortex_m4::Masked masked;
    before = status.read();
    left = ndtr.read();
    after = status.read();
    full = laps.load();
    if (idle_now != nullptr) *idle_now = idle;
  }
  const std::uint32_t position = (ring.size - left) & (ring.size - 1);
  const bool was_full = (stream.flags_in(before) & dma::kFlagComplete) != 0;
  const bool is_full = (stream.flags_in(after) & dma::kFlagComplete) != 0;
  return {full + (was_full || (is_full && position < ring.size / 2) ? 1 : 0), position};
}

// The flag of a lap comes after its last byte was counted: a count that seems to step back lacks that lap. What was
// counted before only has to be less than a lap behind, so an interrupt that counts meanwhile does no harm.
std::uint32_t UartHardware::forward(std::uint32_t before, std::uint32_t count) {
  if (static_cast<std::int32_t>(count - before) < 0) count += ring.size;
  counted.store(count);
  return count;
}

UartIdle UartPort::idle() const {
  const cortex_m4::Masked masked;
  return hardware_->idle;
}

bool UartPort::tells_silence_after(std::uint32_t received) const {
  return !hardware_->quiet.load() && static_cast<std::int32_t>(received - hardware_->resumed_from) > 0;
}

UartErrors UartPort::errors() const { return hardware_->errors; }

bool UartPort::receive_halted() const { return hardware_->halted.load(); }

// An event in between counts the bytes as they will be: at the begin of the ring there is no lap less than before.
std::uint32_t UartPort::restart_receive() {
  const UartSetup& setup = hardware_->setup;
  const UartRing& ring = hardware_->ring;
  stop_stream(setup.receive);
  const std::uint32_t next = (received() + ring.size - 1) & ~(ring.size - 1);
  setup.receive.ndtr().write(ring.size);
  hardware_->laps.store(next / ring.size);
  hardware_->halted.store(false);
  {
    const cortex_m4::Masked masked;
    hardware_->idle = UartIdle{next, kLongAgo};
  }
  start_receive(setup, ring);
  return next;
}

void UartPort::drive_with(std::uint8_t pin, bool active_low) {
  hardware_->driver = {static_cast<char>('A' + pin / 16), static_cast<std::uint8_t>(pin % 16)};
  hardware_->driver_low = active_low;
  hardware_->directed = true;
}

std::uint8_t* UartPort::transmit_buffer() { return hardware_->setup.transmit_buffer; }

std::size_t UartPort::transmit_capacity() const { return kUartTransmit; }

bool UartPort::transmitting() const { return hardware_->sending.load(); }

void UartPort::transmit(std::size_t size) {
  if (size == 0 || size > kUartTransmit) return;
  const UartSetup& setup = hardware_->setup;
  stop_stream(setup.transmit);
  setup.transmit.par().write(setup.usart.dr().address());
  setup.transmit.m0ar().write(address_of(hardware_->setup.transmit_buffer));
  setup.transmit.ndtr().write(size);
  hardware_->sending.store(true);
  const std::uint32_t stream = std::uint32_t{setup.channel} << dma::kChannelShift | dma::kMemoryIncrement |
                               dma::kMemoryToPeripheral | dma::kEnable;
  setup.usart.sr().write(~usart::kTransmitComplete);  // cleared by writing 0; ones leave the others: RM0090 30.6.1
  {
    const cortex_m4::Masked masked;
    setup.usart.cr1().set(usart::kCompleteInterrupt);
  }
  const cortex_m4::Masked masked;  // the line is driven from the first bit to the last, whatever comes
  hardware_->drive(true);
  setup.transmit.cr().write(stream);
}

void UartPort::abort_transmit() {
  {
    const cortex_m4::Masked masked;
    hardware_->setup.usart.cr1().clear(usart::kCompleteInterrupt);
  }
  stop_stream(hardware_->setup.transmit);
  hardware_->drive(false);
  hardware_->sending.store(false);
}

/// Bytes that have not left are those of a stream that has died, or the end was that of a block which this one cut
/// short. The flag alone goes then, which would raise the line for ever: a later end comes, or the deadline.
[[gnu::always_inline]] inline void UartHardware::end_transmit() {
  only_if_raised_by<Raised::end>();
  if (setup.transmit.ndtr().read() != 0) {
    only_after_fault();
    setup.usart.sr().write(~usart::kTransmitComplete);
    return;
  }
  setup.usart.cr1().clear(usart::kCompleteInterrupt);
  drive(false);
  sending.store(false);
}

void UartHardware::on_usart() {
  only_if_raised_by<Raised::event, Raised::end>();
  const cortex_m4::UrgentInterrupt interrupt;
  const stm32f4::UsartRegisters& registers = setup.usart;
  const std::uint32_t status = registers.sr().read();
  const bool has_event = (status & (usart::kErrors | usart::kIdle)) != 0;
  if (!quiet.load() && has_event) take_events(status, interrupt.event().earliest);
  const bool waiting = (registers.cr1().read() & usart::kCompleteInterrupt) != 0;
  if (waiting && (status & usart::kTransmitComplete) != 0) end_transmit();
  stm32f4::settle(registers.cr1());
}

void UartHardware::take_events(std::uint32_t status, Time at) {
  only_if_raised_by<Raised::event>();
  // Status, then data register: clears these flags (RM0090 30.6.1). The byte itself was taken by the DMA long ago.
  static_cast<void>(setup.usart.dr().read());
  errors.framing += (status & usart::kFramingError) != 0 ? 1 : 0;
  errors.noise += (status & usart::kNoise) != 0 ? 1 : 0;
  errors.parity += (status & usart::kParityError) != 0 ? 1 : 0;
  errors.overrun += (status & usart::kOverrun) != 0 ? 1 : 0;
  if ((status & usart::kIdle) != 0) {
    // Where nothing came since events were allowed again, the line may have been silent for long: of its last byte is
    // known that it is no older than the last event before.
    const std::uint32_t count = this->count();  // all of it in memory: a byte's time ago nothing came
    idle = UartIdle{count, count == resumed_from ? quiet_since : at};
  }
  const std::uint32_t left = events_left.load();
  events_left.store(left - 1);
  if (left > 1) return;
  quiet_since = at;
  quiet.store(true);
  setup.usart.cr1().clear(kEventInterrupts);
  setup.usart.cr3().write(kByDma);
}

void UartHardware::on_receive_dma() {
  only_if_raised_by<Raised::received>();
  const cortex_m4::UrgentInterrupt interrupt;
  const std::uint32_t flags = setup.receive.flags();
  setup.receive.clear_flags(flags);
  if ((flags & dma::kFlagComplete) != 0) laps.store(laps.load() + 1);
  if ((flags & dma::kFlagError) != 0) halted.store(true);
  stm32f4::settle(setup.receive.cr());
}

}  // namespace finemote
