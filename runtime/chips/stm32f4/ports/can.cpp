// CanPort on the chip's bxCAN: filters for identifiers and blocks of them, three mailboxes sent by identifier, FIFO 0.
// RM0090 32.
#include "finemote/can.hpp"

#include "finemote/fault.hpp"
#include "finemote/only_after_fault.hpp"
#include "finemote/raised_by.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
#include "runtime/chips/cortex_m4/urgent_interrupt.hpp"
#include "runtime/chips/stm32f4/clock.hpp"
#include "runtime/chips/stm32f4/interrupt.hpp"
#include "runtime/chips/stm32f4/ports/can_hardware.hpp"
#include "runtime/chips/stm32f4/registers/clock.hpp"
#include "runtime/chips/stm32f4/wait.hpp"

namespace finemote {
namespace {

namespace can = stm32f4::can;
namespace rcc = stm32f4::rcc;
using stm32f4::CanSetup;
using stm32f4::wait_for;

enum class CanFault : std::uint8_t {
  init = 16,  ///< the controller does not enter its initialisation mode
  overrun,    ///< a frame came while the FIFO was full
};

constexpr std::uint8_t kPriority = cortex_m4::kBusPriority;

/// The present frame must end first: 130 bits at 125 kbit/s are 1 ms, and ST's drivers allow 10 ms. A poll takes at
/// least 6 cycles at 168 MHz.
constexpr std::uint32_t kInitPolls = 280'000;
/// A few clocks of APB1, RM0090 32.9.2, RFOM; these are sixteen.
constexpr std::uint32_t kReleaseLimit = 16 * (cortex_m4::kCoreHz / stm32f4::kApb1Hz);

// A bit is 14 quanta of the 42 MHz clock divided: one to synchronise, 10, 3; sample point 78.6 %.
constexpr std::uint32_t kSegment1 = 10, kSegment2 = 3, kQuanta = 1 + kSegment1 + kSegment2;

std::uint32_t bit_timing(std::uint32_t bitrate) {  // BTR, RM0090 32.7.7; each field holds its value less one
  const std::uint32_t prescaler = (stm32f4::kApb1Hz / kQuanta + bitrate / 2) / bitrate;  // the nearest
  return (kSegment2 - 1) << 20 | (kSegment1 - 1) << 16 | (prescaler - 1);
}

constexpr std::uint32_t kBanks = 14;

/// An identifier as a 16-bit filter holds it: bits 5 to 15 (RM0090 32.7.4, figure "filter bank scale").
std::uint32_t filter_entry(std::uint16_t id) { return static_cast<std::uint32_t>(id & 0x7FFU) << 5; }

/// Identifier and mask of a block: remote and extended frames, bits 4 and 3, are no part of it.
std::uint32_t filter_block(const CanIds& ids) {
  const std::uint32_t mask = filter_entry(static_cast<std::uint16_t>(~(ids.count - 1U))) | 0x18U;
  return mask << 16 | filter_entry(ids.first);
}

/// Fills filter banks one after the other: four identifiers or two blocks in each.
class FilterBanks {
 public:
  explicit FilterBanks(std::uint32_t first) : first_(first) {}

  void add(const CanIds& ids) {
    if (ids.count == 1)
      add_single(filter_entry(ids.first));
    else
      add_block(filter_block(ids));
  }
  /// What is left goes into a last bank of each kind, which repeats one. Every identifier passes where there are too
  /// few banks.
  void finish() {
    const std::uint32_t single = singles_[0];
    while (singles_count_ > 0) add_single(single);
    if (block_ != 0) add_block(block_);
    if (used_ > kBanks) let_everything_in();
  }

 private:
  void add_single(std::uint32_t entry) {
    singles_[singles_count_++] = entry;
    if (singles_count_ < 4) return;
    put(true, singles_[1] << 16 | singles_[0], singles_[3] << 16 | singles_[2]);
    singles_count_ = 0;
  }
  void add_block(std::uint32_t block) {
    if (block_ != 0) put(false, block_, block);
    block_ = block_ != 0 ? 0 : block;
  }
  /// One bank with mask 0.
  void let_everything_in() {
    can::fa1r.clear(((1U << kBanks) - 1) << first_);
    used_ = 0;
    put(false, 0, 0);
  }
  void put(bool is_list, std::uint32_t low, std::uint32_t high) {
    if (++used_ > kBanks) return;
    const std::uint32_t number = first_ + used_ - 1;
    if (is_list)
      can::fm1r.set(stm32f4::bit(number));
    else
      can::fm1r.clear(stm32f4::bit(number));
    can::filter(number, 0).write(low);
    can::filter(number, 1).write(high);
    can::fa1r.set(stm32f4::bit(number));
  }

  std::uint32_t first_, used_ = 0;
  std::uint32_t singles_[4]{}, singles_count_ = 0;  ///< that wait for a full bank
  std::uint32_t block_ = 0;                         ///< that waits; 0: none does, a block's mask is never 0
};

void set_filters(std::uint32_t first, const CanBus& bus) {
  // The other bits keep their reset value: RM0090 32.9.4.
  can::fmr.modify(can::kSplitMask | can::kFilterInit, kBanks << can::kSplitShift | can::kFilterInit);
  const std::uint32_t mine = ((1U << kBanks) - 1) << first;
  can::fa1r.clear(mine);
  can::fs1r.clear(mine);   // 16 bits
  can::ffa1r.clear(mine);  // FIFO 0
  FilterBanks banks(first);
  bus.each_ids([&banks](const CanIds& ids) { banks.add(ids); });
  banks.finish();
  can::fmr.clear(can::kFilterInit);
}

std::uint32_t word_of(const std::uint8_t* bytes) {
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

void put_word(std::uint8_t* bytes, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(word >> (8 * i));
}

}  // namespace

void CanPort::configure(std::int64_t bitrate, CanBus& bus) {
  const CanSetup& setup = hardware_->setup;
  hardware_->bus.set(&bus);
  const stm32f4::PinSetup pin{stm32f4::PinMode::alternate, stm32f4::PinPull::up, false, setup.alternate_function};
  stm32f4::configure(setup.rx, pin);
  stm32f4::configure(setup.tx, pin);
  rcc::enable(rcc::apb1enr, setup.clock_bits);
  setup.can.mcr().write(can::kInitRequest);  // out of sleep, too: RM0090 32.4
  if (!wait_for(setup.can.msr(), can::kInitAcknowledge, can::kInitAcknowledge, kInitPolls)) {
    count_fault(Module::can, static_cast<std::uint8_t>(CanFault::init));
  }
  setup.can.btr().write(bit_timing(static_cast<std::uint32_t>(bitrate)));
  set_filters(setup.first_bank, bus);
  setup.can.ier().write(can::kReceiveInterrupt | can::kBusOffInterrupt | can::kErrorInterrupt);
  setup.can.mcr().write(0);  // joins the bus by itself after eleven recessive bits: RM0090 32.4.2
  cortex_m4::enable_line(setup.transmit_line, kPriority);
  cortex_m4::enable_line(setup.receive_line, kPriority);
  cortex_m4::enable_line(setup.error_line, kPriority);
}

void CanPort::pend() { stm32f4::pend_line(hardware_->setup.transmit_line); }

bool CanPort::send(const CanFrame& frame) {
  const stm32f4::CanRegisters& registers = hardware_->setup.can;
  const std::uint32_t empty = registers.tsr().read() >> can::kEmptyShift & 7;
  if (empty == 0) return false;
  const std::uint32_t number = (empty & 1) != 0 ? 0 : (empty & 2) != 0 ? 1 : 2;
  registers.mailbox(number, 1).write(frame.size);
  registers.mailbox(number, 2).write(word_of(frame.data));
  registers.mailbox(number, 3).write(word_of(frame.data + 4));
  registers.mailbox(number, 0).write(static_cast<std::uint32_t>(frame.id & 0x7FFU) << can::kIdentifierShift |
                                     can::kSend);
  return true;
}

void CanPort::tell_when_sent() { hardware_->setup.can.ier().set(can::kTransmitInterrupt); }

unsigned CanPort::unsent() const {
  const std::uint32_t empty = hardware_->setup.can.tsr().read() >> can::kEmptyShift;
  return 3 - (empty & 1) - (empty >> 1 & 1) - (empty >> 2 & 1);
}

// Frames that wait follow one another after three recessive bits, between which nobody is receiver: ISO 11898-1.
bool CanPort::idle(std::int64_t bitrate) const {
  constexpr std::uint32_t kPoll = 4;  // cycles, at least
  const std::uint32_t eleven_bits = 11 * (cortex_m4::kCoreHz / static_cast<std::uint32_t>(bitrate));
  return !wait_for(hardware_->setup.can.msr(), can::kReceiving, can::kReceiving, eleven_bits / kPoll + 1);
}

void CanPort::abort() { hardware_->setup.can.tsr().write(can::kAbort | can::kAbort << 8 | can::kAbort << 16); }

bool CanPort::bus_off() const { return hardware_->setup.can.esr().any(can::kBusOff); }

// Into initialisation mode, as soon as the bus allows, and out again; then the controller counts the recessive bits:
// RM0090 32.7.6.
bool CanPort::recover() {
  const stm32f4::CanRegisters& registers = hardware_->setup.can;
  registers.mcr().write(can::kInitRequest);
  if (!registers.msr().any(can::kInitAcknowledge)) return false;
  registers.mcr().write(0);
  return true;
}

std::uint16_t CanPort::error_counters() const {
  return static_cast<std::uint16_t>(hardware_->setup.can.esr().read() >> 16);
}

// The request comes here, too. The end of a frame interrupts only while a frame waits for it: where all mailboxes were
// full, a flag that was not cleared here is that of a frame whose end came behind (RM0090 32.9.2, RQCP).
void CanHardware::on_transmit() {
  only_if_raised_by<Raised::request, Raised::end>();
  const cortex_m4::UrgentInterrupt interrupt;
  const stm32f4::CanRegisters& registers = setup.can;
  registers.ier().clear(can::kTransmitInterrupt);
  // Flags are cleared by writing 1; the zeros leave the rest alone, abort requests included.
  registers.tsr().write(can::kCompleted | can::kCompleted << 8 | can::kCompleted << 16);
  bus->on_interrupt();
  stm32f4::settle(registers.mcr());
}

void CanHardware::on_receive() {
  only_if_raised_by<Raised::received>();
  const cortex_m4::UrgentInterrupt interrupt;
  const stm32f4::CanRegisters& registers = setup.can;
  if (registers.rf0r().any(can::kOverrun)) {
    registers.rf0r().write(can::kOverrun);
    bus->on_overrun();
    count_fault(Module::can, static_cast<std::uint8_t>(CanFault::overrun));
  }
  for (unsigned i = 0; i < 3 && registers.rf0r().any(can::kPendingMask); ++i) {  // the FIFO is three deep
    once_for_each<Raised::received>();
    const std::uint32_t identifier = registers.received(0).read();
    CanFrame frame;
    frame.id = static_cast<std::uint16_t>(identifier >> can::kIdentifierShift);
    const std::uint32_t size = registers.received(1).read() & 0xF;
    frame.size = static_cast<std::uint8_t>(size < 8 ? size : 8);
    put_word(frame.data, registers.received(2).read());
    put_word(frame.data + 4, registers.received(3).read());
    registers.rf0r().write(can::kRelease);
    static_cast<void>(stm32f4::wait_within(registers.rf0r(), can::kRelease, 0, cortex_m4::cycles(), kReleaseLimit));
    if ((identifier & can::kExtendedOrRemote) == 0) bus->on_frame(frame, interrupt.event());
  }
  stm32f4::settle(registers.mcr());
}

void CanHardware::on_error() {
  only_after_fault();
  const cortex_m4::UrgentInterrupt interrupt;
  setup.can.msr().write(can::kErrorFlag);
  stm32f4::settle(setup.can.mcr());
}

}  // namespace finemote
