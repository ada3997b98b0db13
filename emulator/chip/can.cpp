#include "emulator/chip/can.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kInit = 1, kSleep = 2, kByRequest = 4, kLockedFifo = 8, kNoRetransmission = 16, kWakeUp = 32,
                        kAutomaticRecovery = 64, kMasterReset = 1U << 15;
constexpr std::uint32_t kTransmitInterrupt = 1, kReceiveInterrupt = 2, kFullInterrupt = 4, kOverrunInterrupt = 8,
                        kWarningInterrupt = 1U << 8, kPassiveInterrupt = 1U << 9, kBusOffInterrupt = 1U << 10,
                        kCodeInterrupt = 1U << 11, kErrorInterrupt = 1U << 15;
constexpr std::uint32_t kKnownInterrupts = 0x7F | kWarningInterrupt | kPassiveInterrupt | kBusOffInterrupt |
                                           kCodeInterrupt | kErrorInterrupt | 1U << 16 | 1U << 17;
constexpr std::uint32_t kLoopBack = 1U << 30, kSilent = 1U << 31, kSelfTest = kLoopBack | kSilent;   // BTR: 32.4.4
constexpr std::uint32_t kWarning = 1, kPassive = 2, kBusOff = 4;                                     // ESR: 32.9.2
constexpr std::uint32_t kNotAcknowledged = 3U << 4, kRecessiveWrong = 4U << 4, kLastCode = 7U << 4;  // ESR.LEC
constexpr std::size_t kOwnNode = 0;  // of either line: it is the first to be attached

}  // namespace

CanFrame Can::Mailbox::frame() const {
  CanFrame frame;
  frame.id = words[0] >> 21;
  frame.size = (words[1] & 0xF) > 8 ? 8 : words[1] & 0xF;
  for (unsigned i = 0; i < 8; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(words[2 + i / 4] >> (8 * (i % 4)));
    frame.tags[i] = tags[2 + i / 4][i % 4];
  }
  return frame;
}

Can::Can(World& world, std::string name, Lines lines, CanFilters& filters, bool second,
         std::function<std::uint32_t()> clock_hz)
    : Peripheral(world, std::move(name)),
      line(world),
      own_(world),
      lines_(lines),
      filters_(filters),
      second_(second),
      clock_hz_(std::move(clock_hz)) {
  const auto tell = [this](const CanFrame& f, CanOutcome outcome) { sent(f, outcome); };
  const auto take = [this](const CanFrame& f) { received(f); };
  line.attach(CanLine::Node{[this] { return tests_itself() ? std::nullopt : next(); }, tell,
                            [this, take](const CanFrame& f) {
                              if (!tests_itself()) take(f);
                            }});
  own_.attach(CanLine::Node{[this] { return tests_itself() ? next() : std::nullopt; }, tell, {}});
  own_.attach(CanLine::Node{{}, {}, take});  // itself
  reset();
}

void Can::reset() {
  mcr_ = 0x00010002;
  ier_ = esr_ = completed_ = 0;
  btr_ = 0x01230000;
  transmit_errors_ = 0;
  initialising_ = true;  // asleep
  acknowledged_ = error_flag_ = false;
  mailboxes_ = {};
  offered_.reset();
  fifos_ = {};
  if (!second_) filters_ = CanFilters{};
  update();
}

void Can::update() {
  world_.set_line(lines_.transmit, (ier_ & kTransmitInterrupt) != 0 && completed_ != 0);
  for (unsigned i = 0; i < 2; ++i) {
    const Fifo& fifo = fifos_[i];
    const std::uint32_t wanted = ier_ >> (3 * i);
    world_.set_line(lines_.receive[i], ((wanted & kReceiveInterrupt) != 0 && !fifo.frames.empty()) ||
                                           ((wanted & kFullInterrupt) != 0 && fifo.full) ||
                                           ((wanted & kOverrunInterrupt) != 0 && fifo.overrun));
  }
  world_.set_line(lines_.error, (ier_ & kErrorInterrupt) != 0 && error_flag_);
}

/// Loop-back combined with silent mode: what it sends it hears inside, and the bus neither hears nor disturbs it.
bool Can::tests_itself() const { return (btr_ & kSelfTest) == kSelfTest; }

std::uint32_t Can::bitrate() const {
  const std::uint32_t quanta = 1 + ((btr_ >> 16 & 0xF) + 1) + ((btr_ >> 20 & 7) + 1);
  return clock_hz_() / ((btr_ & 0x3FF) + 1) / quanta;
}

/// The smaller identifier, or with TXFP the earlier request; equal identifiers by mailbox: 32.7.1.
bool Can::goes_before(const Mailbox& a, const Mailbox& b) const {
  return (mcr_ & kByRequest) != 0 ? a.request < b.request : a.words[0] >> 21 < b.words[0] >> 21;
}

const Can::Mailbox* Can::most_urgent() const {
  const Mailbox* best = nullptr;
  for (const Mailbox& mailbox : mailboxes_) {
    if (mailbox.waiting && (best == nullptr || goes_before(mailbox, *best))) best = &mailbox;
  }
  return best;
}

std::optional<CanFrame> Can::next() {
  offered_.reset();
  const Mailbox* mailbox = on_bus() ? most_urgent() : nullptr;
  if (mailbox == nullptr) return std::nullopt;
  offered_ = static_cast<unsigned>(mailbox - mailboxes_.data());
  return mailbox->frame();
}

/// The line asks for no other frame before the end of the one that won.
bool Can::is_on_wire(unsigned mailbox) { return wire().sender() == kOwnNode && offered_ == mailbox; }

void Can::sent(const CanFrame& frame, CanOutcome outcome) {
  const bool ok = outcome == CanOutcome::received;
  if (!ok) count_error(outcome);
  if (ok && transmit_errors_ > 0) --transmit_errors_;
  // Not so after a reset in the middle of the frame.
  if (offered_ && mailboxes_[*offered_].words[0] >> 21 == frame.id) complete(*offered_, ok);
  update();
}

/// A failed one tries again, unless the controller or an abort forbids it: RM0090 32.7.1.
void Can::complete(unsigned index, bool ok) {
  Mailbox& mailbox = mailboxes_[index];
  if (!ok && (mcr_ & kNoRetransmission) == 0 && !mailbox.aborting) return;
  mailbox.waiting = mailbox.aborting = false;
  completed_ |= (ok ? 3U : 9U) << (8 * index);  // RQCP with TXOK or TERR
}

/// At once, but the frame on the wire goes on: its mailbox is empty at its end, with TXOK if it was sent after all, and
/// does not try again if it was not: RM0090 32.7.1.
void Can::abort(unsigned index) {
  Mailbox& mailbox = mailboxes_[index];
  if (!mailbox.waiting) return;
  mailbox.aborting = is_on_wire(index);
  if (mailbox.aborting) return;
  mailbox.waiting = false;
  completed_ |= 1U << (8 * index);  // RQCP alone
}

/// A failed transmission: eight more; above 255 the controller leaves the bus. Not so when nobody acknowledges an
/// error-passive node: its count stays (ISO 11898-1).
void Can::count_error(CanOutcome outcome) {
  const bool unheard = outcome == CanOutcome::unacknowledged;
  esr_ = (esr_ & ~kLastCode) | (unheard ? kNotAcknowledged : kRecessiveWrong);
  if (outcome == CanOutcome::unacknowledged && transmit_errors_ >= 128) return;
  transmit_errors_ += 8;
  if (transmit_errors_ > 255) {
    esr_ |= kBusOff;
    if ((mcr_ & kAutomaticRecovery) != 0) recover();
  }
  note_error();
  update();
}

/// ERRI: one of the conditions that have an interrupt has come about.
void Can::note_error() {
  const std::uint32_t status = error_status();
  error_flag_ = error_flag_ || ((status & kWarning) != 0 && (ier_ & kWarningInterrupt) != 0) ||
                ((status & kPassive) != 0 && (ier_ & kPassiveInterrupt) != 0) ||
                ((status & kBusOff) != 0 && (ier_ & kBusOffInterrupt) != 0) ||
                ((status & kLastCode) != 0 && (ier_ & kCodeInterrupt) != 0);
}

std::uint32_t Can::error_status() const {
  return esr_ | (transmit_errors_ >= 96 ? kWarning : 0) | (transmit_errors_ >= 128 ? kPassive : 0) |
         (transmit_errors_ > 255 ? 255U : transmit_errors_) << 16;
}

/// Back on the bus after 128 times eleven recessive bits, from the start if initialisation mode was entered meanwhile:
/// RM0090 32.7.6.
void Can::recover() { count_recessive(++recovery_, 128, wire().frames()); }

/// An idle line has eleven recessive bits after eleven others, a busy one at the end of each frame.
/// @param left    how many times more
/// @param frames  that had ended before
void Can::count_recessive(unsigned recovery, std::uint64_t left, std::uint64_t frames) {
  const Time eleven = 11 * wire().bit_time();
  world_.after(eleven, [this, recovery, left, frames, eleven] {
    if (initialising_ || recovery != recovery_) return;
    const std::uint64_t seen = wire().frames() - frames + (wire().is_idle_for(eleven) ? 1 : 0);
    if (seen < left) return count_recessive(recovery, left - seen, wire().frames());
    esr_ &= ~4U;
    transmit_errors_ = 0;
    wire().request();
  });
}

void Can::received(const CanFrame& frame) {
  const auto match = on_bus() ? filters_.match(frame.id, second_) : std::nullopt;
  if (!match) return;
  Fifo& fifo = fifos_[match->fifo];
  if (fifo.frames.size() == 3) {
    fifo.overrun = true;
    if ((mcr_ & kLockedFifo) != 0) return update();
    fifo.frames.pop_back();  // without RFLM the last one is overwritten
  }
  fifo.frames.push_back({frame, match->number});
  fifo.full = fifo.full || fifo.frames.size() == 3;
  update();
}

void Can::write_mcr(std::uint32_t value) {
  only(value,
       kInit | kSleep | kByRequest | kLockedFifo | kNoRetransmission | kWakeUp | kAutomaticRecovery | kMasterReset |
           0x10000,
       "MCR");
  if ((value & kMasterReset) != 0) return reset();
  const bool was = initialising_;
  const std::uint32_t rising = value & ~mcr_;
  mcr_ = value;
  if ((value & kInit) == 0) acknowledged_ = false;
  if ((rising & kInit) != 0) return enter_initialisation();
  if ((value & kInit) != 0) return;
  initialising_ = (value & kSleep) != 0;
  if (!was || initialising_) return;
  wire().set_bitrate(bitrate());
  bus_off() ? recover() : wire().request();
}

/// At once, or as late as the chip is; nothing comes of a request that is taken back before.
void Can::enter_initialisation() {
  const auto enter = [this] {
    if ((mcr_ & kInit) == 0) return;
    acknowledged_ = initialising_ = true;
    ++recovery_;
  };
  const std::uint32_t late_us = world_.silicon().draw_or_zero(Strictness::can_init);
  late_us == 0 ? enter() : world_.after(from_ns(std::uint64_t{late_us} * 1'000), enter);
}

std::uint32_t Can::read_received(const Fifo& fifo, unsigned word) {
  if (fifo.frames.empty()) return 0;
  const auto& [frame, match] = fifo.frames.front();
  if (word == 0) return frame.id << 21;
  if (word == 1) return frame.size | match << 8;
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i) {
    value |= std::uint32_t{frame.data[4 * (word - 2) + i]} << (8 * i);
    world_.crossing()[i] = frame.tags[4 * (word - 2) + i];
  }
  return value;
}

/// CODE is the next free mailbox; where none is free, the one that will be sent last, as LOW says too: 32.9.2.
std::uint32_t Can::transmit_status() const {
  std::uint32_t empty = 0, code = 0;
  const Mailbox* last = nullptr;
  unsigned waiting = 0;
  for (unsigned i = 3; i-- > 0;) {
    const Mailbox& mailbox = mailboxes_[i];
    if (mailbox.waiting) {
      ++waiting;
      if (last == nullptr || goes_before(*last, mailbox)) last = &mailbox;
    } else {
      empty |= 1U << i;
      code = i;
    }
  }
  const unsigned lowest = last == nullptr ? 0 : static_cast<unsigned>(last - mailboxes_.data());
  if (empty == 0) code = lowest;
  return completed_ | code << 24 | empty << 26 | (waiting > 1 ? 1U << (29 + lowest) : 0);
}

std::uint32_t Can::fifo_status(const Fifo& fifo) const {
  return static_cast<std::uint32_t>(fifo.frames.size()) | (fifo.full ? 8U : 0) | (fifo.overrun ? 16U : 0);
}

/// TXM and RXM: who sends the frame on the bus. RX and SAMP: recessive, as bits are not modelled.
std::uint32_t Can::master_status() {
  const auto sender = on_bus() ? wire().sender() : std::nullopt;
  const std::uint32_t mode = !sender ? 0 : 1U << (*sender == kOwnNode ? 8 : 9);
  return (acknowledged_ ? 1U : 0) | ((mcr_ & (kInit | kSleep)) == kSleep ? 2U : 0) | (error_flag_ ? 4U : 0) | mode |
         0xC00;
}

std::uint32_t Can::read(std::uint32_t offset) {
  if (offset >= 0x200) {
    const auto value = filters_.read(offset);
    return value ? *value : unmodelled_read(offset);
  }
  if (offset >= 0x180 && offset < 0x1B0) return mailboxes_[(offset - 0x180) / 16].words[offset / 4 % 4];
  if (offset >= 0x1B0 && offset < 0x1D0) return read_received(fifos_[(offset - 0x1B0) / 16], offset / 4 % 4);
  switch (offset) {
    case 0x00:
      return mcr_;
    case 0x04:
      return master_status();
    case 0x08:
      return transmit_status();
    case 0x0C:
    case 0x10:
      return fifo_status(fifos_[(offset - 0x0C) / 4]);
    case 0x14:
      return ier_;
    case 0x18:
      return error_status();
    case 0x1C:
      return btr_;
    default:
      return unmodelled_read(offset);
  }
}

void Can::write_mailbox(unsigned index, unsigned word, std::uint32_t value) {
  Mailbox& mailbox = mailboxes_[index];
  if (mailbox.waiting) world_.report(Misuse::protocol, name() + " mailbox is written while it waits");
  mailbox.words[word] = value;
  mailbox.tags[word] = world_.crossing();
  if (word != 0 || (value & 1) == 0) return;
  if ((value & 6) != 0) world_.report(Misuse::unmodelled, name() + " extended or remote frame");
  mailbox.waiting = true;
  mailbox.aborting = false;
  mailbox.request = ++requests_;
  completed_ &= ~(0xFU << (8 * index));  // a request to transmit clears it: RM0090 32.9.2
  wire().request();
}

void Can::write_transmit_status(std::uint32_t value) {
  for (unsigned i = 0; i < 3; ++i) {
    if ((value >> (8 * i) & 1) != 0) completed_ &= ~(0xFU << (8 * i));
    if ((value >> (8 * i + 7) & 1) != 0) abort(i);
  }
}

void Can::write_fifo(Fifo& fifo, std::uint32_t value) {
  if ((value & 8) != 0) fifo.full = false;
  if ((value & 16) != 0) fifo.overrun = false;
  if ((value & 32) != 0 && !fifo.frames.empty()) fifo.frames.pop_front();
}

void Can::write_filter(std::uint32_t offset, std::uint32_t value) {
  if (second_) return unmodelled_write(offset);
  if (!filters_.is_open() && !CanFilters::is_master(offset))
    world_.report(Misuse::protocol, "CAN filters are written outside their initialisation mode");
  if (!filters_.write(offset, value)) unmodelled_write(offset);
}

void Can::write(std::uint32_t offset, std::uint32_t value) {
  if (offset >= 0x200) return write_filter(offset, value);
  if (offset >= 0x180 && offset < 0x1B0) return write_mailbox((offset - 0x180) / 16, offset / 4 % 4, value);
  switch (offset) {
    case 0x00:
      write_mcr(value);
      break;
    case 0x04:
      error_flag_ = error_flag_ && (value & 4) == 0;
      break;
    case 0x08:
      write_transmit_status(value);
      break;
    case 0x0C:
    case 0x10:
      write_fifo(fifos_[(offset - 0x0C) / 4], value);
      break;
    case 0x14:
      only(value, kKnownInterrupts, "IER");
      ier_ = value;
      break;
    case 0x18:
      esr_ = (esr_ & ~kLastCode) | (value & kLastCode);
      break;
    case 0x1C:
      if ((mcr_ & kInit) == 0)
        world_.report(Misuse::protocol, name() + " bit timing is written outside the initialisation mode");
      only(value, 0x037F03FF | kSelfTest, "BTR");
      if ((value & kSelfTest) == kLoopBack || (value & kSelfTest) == kSilent)
        world_.report(Misuse::unmodelled, name() + " loop-back without silent mode, or that without loop-back");
      btr_ = value;
      break;
    default:
      return unmodelled_write(offset);
  }
  update();
}

}  // namespace finemote::emulator
