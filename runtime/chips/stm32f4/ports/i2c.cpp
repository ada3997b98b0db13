// I2cPort on the chip's I2C, one interrupt per byte. Procedures: RM0090 27.3.3 (master mode).
//
// Writes and the closing of a read follow the variant of the manual that holds the clock (byte transfer finished)
// rather than the one that must be in time: a routine that comes late only slows the bus down. Interrupts of bytes are
// nine bits apart; that of a START is two behind what came before it.
#include "finemote/i2c.hpp"
#include "finemote/fault.hpp"
#include "finemote/loop_bound.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/chips/stm32f4/ports/i2c_hardware.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/wait.hpp"

namespace finemote {
namespace {

namespace i2c = stm32f4::i2c;
namespace rcc = stm32f4::rcc;
using stm32f4::kApb1Hz;
using stm32f4::Pin;
using stm32f4::PinMode;
using stm32f4::PinPull;
using stm32f4::PinSetup;

enum class I2cFault : std::uint8_t {
  bus_error = 16,  ///< misplaced START or STOP seen; ES0182: may be spurious in master mode, so the exchange goes on
  stop_late,       ///< the STOP before was not sent in time
};

constexpr std::uint8_t kPriority = cortex_m4::kSlowBusPriority;
constexpr std::uint32_t kCyclesPerUs = cortex_m4::kCoreHz / 1'000'000;

/// How the driver makes a clock, RM0090 27.6.8 and 27.6.9. Fast mode: low twice as long as high, rise time 300 ns;
/// standard mode: half and half, rise time 1000 ns, and not the range 88 to 100 kHz (ES0182, set-up time of a repeated
/// START).
struct BitTiming {
  bool is_fast;
  std::uint32_t count;    ///< CCR: of the bus' clock, for each of the parts of a bit
  std::uint32_t parts;    ///< of a bit
  std::uint32_t rise_ns;  ///< UM10204, table 10
};

BitTiming bit_timing(std::uint32_t clock_hz) {
  if (clock_hz > 100'000) return {true, (kApb1Hz + 3 * clock_hz - 1) / (3 * clock_hz), 3, 300};
  const std::uint32_t safe_hz = clock_hz > 87'000 ? 87'000 : clock_hz;
  return {false, (kApb1Hz + 2 * safe_hz - 1) / (2 * safe_hz), 2, 1000};
}

/// For how long a STOP is waited for. It is the end of a bit: the low part of the clock, its rise, and the set-up time
/// of the STOP, which the peripheral makes as long as the high part (UM10204, table 10: t_LOW, t_r, t_SU;STO; in fast
/// mode 1.3, 0.3 and 0.6 us at least). Until the flag shows it, a few clocks of APB1 go by; half a microsecond is 21.
/// Nothing but a part that holds the clock low behind the last acknowledge makes it later. No part that ships with
/// FineMote does; UM10204 3.1.9 sets no limit to one that would, so it is not waited for: what it costs is known.
std::uint32_t stop_limit(const BitTiming& timing) {
  constexpr std::uint32_t kSeen_ns = 500;
  return timing.count * timing.parts * (cortex_m4::kCoreHz / kApb1Hz) +
         (timing.rise_ns + kSeen_ns) * kCyclesPerUs / 1000;
}

/// Half a bit of the recovery clock: 100 kHz.
constexpr std::uint32_t kHalfBit = 5 * kCyclesPerUs;
/// A byte and its acknowledge: UM10204 3.1.16.
constexpr unsigned kMostClocks = 9;

/// Ends also when the count stands still, and never early: a turn takes five cycles or more.
void wait_cycles(std::uint32_t count) {
  constexpr std::uint32_t kTurn = 4;
  const std::uint32_t from = cortex_m4::cycles();
  const WaitBound wait(count);
  for (std::uint32_t turns = count / kTurn; turns != 0 && cortex_m4::cycles() - from < count; --turns) wait.pass();
}

void set_clock(const stm32f4::I2cRegisters& registers, const BitTiming& timing) {
  registers.ccr().write((timing.is_fast ? i2c::kFastMode : 0) | timing.count);
  registers.trise().write(kApb1Hz / 1'000'000 * timing.rise_ns / 1000 + 1);
}

}  // namespace

void I2cHardware::set_up() {
  const PinSetup pin{PinMode::alternate, PinPull::up, true, setup.function};
  configure(setup.scl, pin);
  configure(setup.sda, pin);
  setup.i2c.cr1().write(i2c::kSoftwareReset);  // releases the lines and forgets a misplaced STOP: ES0182
  setup.i2c.cr1().write(0);
  setup.i2c.cr2().write(kApb1Hz / 1'000'000 | i2c::kErrorInterrupt | i2c::kEventInterrupt);
  set_clock(setup.i2c, bit_timing(clock_hz));
  setup.i2c.cr1().write(i2c::kOn);
}

void I2cPort::configure(std::int64_t clock_hz, I2cBus& bus) {
  hardware_->bus.set(&bus);
  hardware_->clock_hz.set(static_cast<std::uint32_t>(clock_hz));
  hardware_->stop_limit.set(stop_limit(bit_timing(hardware_->clock_hz)));
  rcc::enable(rcc::apb1enr, hardware_->setup.clock_bit);
  hardware_->set_up();
  cortex_m4::enable_line(hardware_->setup.event_line, kPriority);
  cortex_m4::enable_line(hardware_->setup.error_line, kPriority);
}

void I2cPort::pend() { stm32f4::pend_line(hardware_->setup.event_line); }

bool I2cPort::lines_free() const { return hardware_->setup.scl.is_high() && hardware_->setup.sda.is_high(); }

// Interrupts come before whoever asks: at that instant a step is under way on the wire, or none will be. The longest is
// three bytes: of a read, two, and what begins it.
bool I2cPort::stands_still() const {
  constexpr std::uint32_t kLongestStep = 28;  // of bits, which a STOP is waited for a little more than
  const std::uint32_t before = hardware_->stepped_at.load();
  const std::uint32_t since = cortex_m4::cycles() - before;
  return hardware_->stepped_at.load() == before && since > kLongestStep * hardware_->stop_limit;
}

void I2cPort::begin(const I2cMessage& message) {
  hardware_->message = message;
  hardware_->moved = 0;
  hardware_->reading = message.write_size == 0 && message.read_size != 0;
  hardware_->active = hardware_->begins = true;
}

void I2cPort::abort() {
  hardware_->active = hardware_->begins = false;
  hardware_->setup.i2c.cr2().clear(i2c::kErrorInterrupt | i2c::kEventInterrupt | i2c::kBufferInterrupt);
  hardware_->setup.i2c.cr1().write(0);
}

I2cPort::Recovery I2cPort::recover(unsigned step) {
  const Pin scl = hardware_->setup.scl, sda = hardware_->setup.sda;
  if (step == 0) {
    scl.set(true);
    sda.set(true);
    const PinSetup by_hand{PinMode::output, PinPull::up, true, 0};
    stm32f4::configure(scl, by_hand);
    stm32f4::configure(sda, by_hand);
    wait_cycles(kHalfBit);
  }
  // Two per step: 20 us.
  for (unsigned i = 0; i < 2 && 2 * step + i < kMostClocks && !sda.is_high(); ++i) {
    scl.set(false);
    wait_cycles(kHalfBit);
    scl.set(true);
    wait_cycles(kHalfBit);
  }
  if ((!sda.is_high() || !scl.is_high()) && step + 1 < kMaxRecoverySteps) return Recovery::kBusy;
  if (!sda.is_high() || !scl.is_high()) return Recovery::kStuck;
  scl.set(false);  // SDA may only change while SCL is low; its rise while SCL is high is the STOP
  sda.set(false);
  wait_cycles(kHalfBit);
  scl.set(true);
  wait_cycles(kHalfBit);
  sda.set(true);
  wait_cycles(kHalfBit);
  if (!sda.is_high() || !scl.is_high()) return step + 1 < kMaxRecoverySteps ? Recovery::kBusy : Recovery::kStuck;
  hardware_->set_up();
  return Recovery::kFree;
}

/// Waits for the STOP of the exchange that ended last. Only the routine that ended it finds it pending.
bool I2cHardware::has_stopped() const {
  if (!setup.i2c.cr1().any(i2c::kStop)) return true;
  only_if_raised_by<Raised::end>();
  if (stm32f4::wait_within(setup.i2c.cr1(), i2c::kStop, 0, finished_at, stop_limit)) return true;
  count_fault(Module::i2c, static_cast<std::uint8_t>(I2cFault::stop_late));
  return false;
}

/// The routine that ends an exchange waits for its STOP, whether another one begins or not: a request, which comes at
/// any time, then finds the bus free. The wait is charged to the end of an exchange, and to nothing else.
/// CR1 must not be written while a STOP is pending: RM0090 27.6.1, note on STOP. Where it stays, the next exchange does
/// not begin, and its deadline recovers the bus.
void I2cHardware::hand_on(I2cEvent event) {
  bus->on_interrupt(event);
  if (event != I2cEvent::kNone || begins) {
    only_if_raised_by<Raised::request, Raised::end>();
    const bool is_free = has_stopped();
    if (begins && is_free) setup.i2c.cr1().write(i2c::kOn | i2c::kStart);
    begins = false;
  }
  stm32f4::settle(setup.i2c.cr1());
}

/// The STOP was asked for just now; of a byte that is read alone, when it began, and is due behind it.
I2cEvent I2cHardware::finish(I2cEvent event) {
  only_if_raised_by<Raised::end>();
  active = false;
  finished_at = cortex_m4::cycles();
  setup.i2c.cr2().clear(i2c::kBufferInterrupt);
  return event;
}

void I2cHardware::note_step() { stepped_at.store(cortex_m4::cycles()); }

void I2cHardware::send_address() {
  note_step();
  setup.i2c.dr().write(std::uint32_t{message.address} << 1 | (reading ? 1 : 0));
}

void I2cHardware::take_byte() {
  only_if_raised_by<Raised::step, Raised::end>();
  note_step();
  message.read[moved++] = static_cast<std::uint8_t>(setup.i2c.dr().read());
}

/// The address was acknowledged. Reading SR2 clears the flag and lets the clock go: what must be decided before the
/// first byte is decided before that read.
I2cEvent I2cHardware::address_sent() {
  only_if_raised_by<Raised::step, Raised::end>();
  note_step();
  const stm32f4::I2cRegisters& registers = setup.i2c;
  if (!reading) {
    static_cast<void>(registers.sr2().read());
    if (message.write_size == 0) {
      registers.cr1().write(i2c::kOn | i2c::kStop);
      return finish(I2cEvent::kDone);
    }
    registers.dr().write(message.write[moved++]);
    return I2cEvent::kNone;
  }
  if (message.read_size == 1) {
    registers.cr1().write(i2c::kOn);  // no acknowledge for the only byte
    {
      const cortex_m4::Masked masked;  // the clock runs on from here: the STOP must be asked for within the byte
      static_cast<void>(registers.sr2().read());
      registers.cr1().write(i2c::kOn | i2c::kStop);
    }
    registers.cr2().set(i2c::kBufferInterrupt);
  } else if (message.read_size == 2) {
    registers.cr1().write(i2c::kOn | i2c::kAckNext);  // no acknowledge, counted from the byte after the next
    static_cast<void>(registers.sr2().read());
  } else {
    registers.cr1().write(i2c::kOn | i2c::kAcknowledge);
    static_cast<void>(registers.sr2().read());
    if (message.read_size > 3) registers.cr2().set(i2c::kBufferInterrupt);
  }
  return I2cEvent::kNone;
}

I2cEvent I2cHardware::write_on(std::uint32_t status) {
  const stm32f4::I2cRegisters& registers = setup.i2c;
  if ((status & i2c::kByteFinished) == 0) return I2cEvent::kNone;
  only_if_raised_by<Raised::step, Raised::end>();
  note_step();
  if (moved < message.write_size) {
    registers.dr().write(message.write[moved++]);
    return I2cEvent::kNone;
  }
  if (message.read_size != 0) {
    reading = true;
    moved = 0;
    registers.cr1().write(i2c::kOn | i2c::kStart);
    static_cast<void>(registers.dr().read());  // clears the flag, which would else raise the line until the START
    return I2cEvent::kNone;
  }
  registers.cr1().write(i2c::kOn | i2c::kStop);
  static_cast<void>(registers.dr().read());
  return finish(I2cEvent::kDone);
}

I2cEvent I2cHardware::read_on(std::uint32_t status) {
  const stm32f4::I2cRegisters& registers = setup.i2c;
  const unsigned left = static_cast<unsigned>(message.read_size - moved);
  if (left == 1) {
    if ((status & i2c::kReceived) == 0) return I2cEvent::kNone;
    take_byte();
    return finish(I2cEvent::kDone);
  }
  if (left > 3) {
    if ((status & i2c::kReceived) != 0) take_byte();
    if (message.read_size - moved == 3) registers.cr2().clear(i2c::kBufferInterrupt);  // now wait with the clock held
    return I2cEvent::kNone;
  }
  if ((status & i2c::kByteFinished) == 0) return I2cEvent::kNone;
  if (left == 3) {
    registers.cr1().write(i2c::kOn);  // no acknowledge for the last byte, which this read lets come
    take_byte();
    return I2cEvent::kNone;
  }
  registers.cr1().write(i2c::kOn | i2c::kStop);
  take_byte();
  take_byte();
  return finish(I2cEvent::kDone);
}

I2cEvent I2cHardware::step() {
  if (!active) return I2cEvent::kNone;
  const std::uint32_t status = setup.i2c.sr1().read();
  if ((status & i2c::kStartSent) != 0) {
    send_address();
    return I2cEvent::kNone;
  }
  if ((status & i2c::kAddressSent) != 0) return address_sent();
  // The flags are those of this exchange only once the address is through: a START that is still to come shows neither.
  return reading ? read_on(status) : write_on(status);
}

void I2cHardware::on_event() { hand_on(step()); }

void I2cHardware::on_error() {
  only_after_fault();
  const stm32f4::I2cRegisters& registers = setup.i2c;
  const std::uint32_t status = registers.sr1().read();
  registers.sr1().write(~(status & i2c::kErrors) & 0xDFFF);  // error flags are cleared by writing 0: RM0090 27.6.6
  I2cEvent event = I2cEvent::kNone;
  if ((status & i2c::kBusError) != 0) count_fault(Module::i2c, static_cast<std::uint8_t>(I2cFault::bus_error));
  if (active && (status & (i2c::kArbitrationLost | i2c::kOverrun)) != 0) {
    event = finish(I2cEvent::kError);
  } else if (active && (status & i2c::kNoAcknowledge) != 0) {
    registers.cr1().write(i2c::kOn | i2c::kStop);
    event = finish(I2cEvent::kNack);
  }
  hand_on(event);
}

}  // namespace finemote
