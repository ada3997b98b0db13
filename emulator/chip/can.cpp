#include "emulator/chip/can.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kInit = 1, kSleep = 2, kNoRetransmission = 16, kAutomaticRecovery = 64, kMasterReset = 1U << 15;
constexpr std::uint32_t kTransmitInterrupt = 1, kReceiveInterrupt = 2, kBusOffInterrupt = 1U << 10,
                        kErrorInterrupt = 1U << 15;

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

bool CanFilters::accepts(std::uint32_t id, bool second) const {
  const unsigned split = fmr >> 8 & 0x3F;
  for (unsigned i = second ? split : 0; i < (second ? 28 : split); ++i) {
    if ((active >> i & 1) == 0) continue;
    const bool list = (mode >> i & 1) != 0, wide = (scale >> i & 1) != 0;
    const auto& b = bank[i];
    if (wide) {
      const std::uint32_t value = id << 21;
      if (list ? value == b[0] || value == b[1] : ((value ^ b[0]) & b[1]) == 0) return true;
      continue;
    }
    const std::uint32_t value = id << 5;
    for (const std::uint32_t half : b) {
      const std::uint32_t low = half & 0xFFFF, high = half >> 16;
      if (list ? value == low || value == high : ((value ^ low) & high) == 0) return true;
    }
  }
  return false;
}

Can::Can(World& world, std::string name, Lines lines, CanFilters& filters, bool second,
         std::function<std::uint32_t()> clock_hz)
    : Peripheral(world, std::move(name)),
      line(world),
      lines_(lines),
      filters_(filters),
      second_(second),
      clock_hz_(std::move(clock_hz)) {
  line.attach(CanLine::Node{[this] { return next(); },
                            [this](const CanFrame& f, CanOutcome outcome) { sent(f, outcome); },
                            [this](const CanFrame& f) { received(f); }});
  reset();
}

void Can::reset() {
  mcr_ = 0x00010002;
  ier_ = esr_ = completed_ = 0;
  btr_ = 0x01230000;
  transmit_errors_ = 0;
  initialising_ = true;  // asleep
  error_flag_ = overrun_ = false;
  mailboxes_ = {};
  fifo_.clear();
  if (!second_) filters_ = CanFilters{};
  update();
}

void Can::update() {
  world_.set_line(lines_.transmit, (ier_ & kTransmitInterrupt) != 0 && completed_ != 0);
  world_.set_line(lines_.receive, (ier_ & kReceiveInterrupt) != 0 && !fifo_.empty());
  world_.set_line(lines_.error, (ier_ & kErrorInterrupt) != 0 && error_flag_);
}

std::uint32_t Can::bitrate() const {
  const std::uint32_t quanta = 1 + ((btr_ >> 16 & 0xF) + 1) + ((btr_ >> 20 & 7) + 1);
  return clock_hz_() / ((btr_ & 0x3FF) + 1) / quanta;
}

std::optional<CanFrame> Can::next() const {
  std::optional<CanFrame> best;
  if (!on_bus()) return best;
  for (const Mailbox& mailbox : mailboxes_) {
    if (!mailbox.waiting) continue;
    const CanFrame frame = mailbox.frame();
    if (!best || frame.id < best->id) best = frame;
  }
  return best;
}

void Can::sent(const CanFrame& frame, CanOutcome outcome) {
  const bool ok = outcome == CanOutcome::received;
  if (!ok) count_error(outcome);
  if (!ok && (mcr_ & kNoRetransmission) == 0) return;  // the mailbox tries again
  if (ok && transmit_errors_ > 0) --transmit_errors_;
  for (unsigned i = 0; i < 3; ++i) {
    if (!mailboxes_[i].waiting || mailboxes_[i].words[0] >> 21 != frame.id) continue;
    mailboxes_[i].waiting = false;
    completed_ |= (ok ? 3U : 9U) << (8 * i);  // RQCP with TXOK or TERR
    break;
  }
  update();
}

/// A failed transmission: eight more; above 255 the controller leaves the bus. Not so when nobody acknowledges an
/// error-passive node: its count stays (ISO 11898-1).
void Can::count_error(CanOutcome outcome) {
  if (outcome == CanOutcome::unacknowledged && transmit_errors_ >= 128) return;
  transmit_errors_ += 8;
  if (transmit_errors_ <= 255) return;
  esr_ |= 4;
  error_flag_ = error_flag_ || (ier_ & kBusOffInterrupt) != 0;
  if ((mcr_ & kAutomaticRecovery) != 0) recover();
  update();
}

/// Back on the bus after 128 times eleven recessive bits: RM0090 32.7.6.
void Can::recover() {
  world_.after(128 * 11 * line.bit_time(), [this] {
    if (initialising_) return;
    esr_ &= ~4U;
    transmit_errors_ = 0;
    line.request();
  });
}

void Can::received(const CanFrame& frame) {
  if (!on_bus() || !filters_.accepts(frame.id, second_)) return;
  if (fifo_.size() == 3) {
    overrun_ = true;
    fifo_.pop_back();  // without RFLM the last one is overwritten
  }
  fifo_.push_back(frame);
  update();
}

void Can::write_mcr(std::uint32_t value) {
  only(value, kInit | kSleep | kNoRetransmission | kAutomaticRecovery | kMasterReset | 0x10000, "MCR");
  if ((value & kMasterReset) != 0) return reset();
  const bool was = initialising_;
  mcr_ = value;
  initialising_ = (value & (kInit | kSleep)) != 0;
  if (!was || initialising_) return;
  line.set_bitrate(bitrate());
  bus_off() ? recover() : line.request();
}

std::uint32_t Can::read_filter(std::uint32_t offset) {
  switch (offset) {
    case 0x200:
      return filters_.fmr;
    case 0x204:
      return filters_.mode;
    case 0x20C:
      return filters_.scale;
    case 0x214:
      return filters_.fifo;
    case 0x21C:
      return filters_.active;
    default:
      break;
  }
  if (offset < 0x240 || offset >= 0x240 + 8 * 28) return unmodelled_read(offset);
  return filters_.bank[(offset - 0x240) / 8][(offset >> 2) & 1];
}

void Can::write_filter(std::uint32_t offset, std::uint32_t value) {
  if (second_) return unmodelled_write(offset, value);
  if (offset == 0x200) {
    filters_.fmr = value;
    return;
  }
  if ((filters_.fmr & 1) == 0)
    world_.report(Misuse::protocol, "CAN filters are written outside their initialisation mode");
  switch (offset) {
    case 0x204:
      filters_.mode = value;
      return;
    case 0x20C:
      filters_.scale = value;
      return;
    case 0x214:
      only(value, 0, "FFA1R");
      filters_.fifo = value;
      return;
    case 0x21C:
      filters_.active = value;
      return;
    default:
      break;
  }
  if (offset < 0x240 || offset >= 0x240 + 8 * 28) return unmodelled_write(offset, value);
  filters_.bank[(offset - 0x240) / 8][(offset >> 2) & 1] = value;
}

std::uint32_t Can::read_received(unsigned word) {
  if (fifo_.empty()) return 0;
  const CanFrame& frame = fifo_.front();
  if (word == 0) return frame.id << 21;
  if (word == 1) return frame.size;
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i) {
    value |= std::uint32_t{frame.data[4 * (word - 2) + i]} << (8 * i);
    world_.crossing()[i] = frame.tags[4 * (word - 2) + i];
  }
  return value;
}

std::uint32_t Can::read(std::uint32_t offset) {
  if (offset >= 0x200) return read_filter(offset);
  if (offset >= 0x180 && offset < 0x1B0) return mailboxes_[(offset - 0x180) / 16].words[offset / 4 % 4];
  if (offset >= 0x1B0 && offset < 0x1C0) return read_received(offset / 4 % 4);
  switch (offset) {
    case 0x00:
      return mcr_;
    case 0x04:
      return ((mcr_ & kInit) != 0 ? 1U : 0) | ((mcr_ & (kInit | kSleep)) == kSleep ? 2U : 0) | (error_flag_ ? 4U : 0) |
             0xC00;  // RX and SAMP: the bus is recessive
    case 0x08: {
      std::uint32_t empty = 0;
      for (unsigned i = 0; i < 3; ++i) empty |= mailboxes_[i].waiting ? 0 : 1U << (26 + i);
      return completed_ | empty;
    }
    case 0x0C:
      return static_cast<std::uint32_t>(fifo_.size()) | (fifo_.size() == 3 ? 8U : 0) | (overrun_ ? 16U : 0);
    case 0x10:
      return 0;
    case 0x14:
      return ier_;
    case 0x18:
      return esr_ | (transmit_errors_ >= 96 ? 1U : 0) | (transmit_errors_ >= 128 ? 2U : 0) |
             (transmit_errors_ > 255 ? 255U : transmit_errors_) << 16;
    case 0x1C:
      return btr_;
    default:
      return unmodelled_read(offset);
  }
}

void Can::write(std::uint32_t offset, std::uint32_t value) {
  if (offset >= 0x200) return write_filter(offset, value);
  if (offset >= 0x180 && offset < 0x1B0) {
    Mailbox& mailbox = mailboxes_[(offset - 0x180) / 16];
    const unsigned word = offset / 4 % 4;
    if (mailbox.waiting) world_.report(Misuse::protocol, name() + " mailbox is written while it waits");
    mailbox.words[word] = value;
    mailbox.tags[word] = world_.crossing();
    if (word == 0 && (value & 1) != 0) {
      if ((value & 6) != 0) world_.report(Misuse::unmodelled, name() + " extended or remote frame");
      mailbox.waiting = true;
      completed_ &= ~(0xFU << (8 * ((offset - 0x180) / 16)));  // a request to transmit clears it: RM0090 32.9.2
      line.request();
    }
    return;
  }
  switch (offset) {
    case 0x00:
      write_mcr(value);
      break;
    case 0x04:
      error_flag_ = error_flag_ && (value & 4) == 0;
      break;
    case 0x08:
      for (unsigned i = 0; i < 3; ++i) {
        if ((value >> (8 * i) & 1) != 0) completed_ &= ~(0xFU << (8 * i));
        if ((value >> (8 * i + 7) & 1) != 0 && mailboxes_[i].waiting) {
          mailboxes_[i].waiting = false;
          completed_ |= 1U << (8 * i);
        }
      }
      break;
    case 0x0C:
      if ((value & 16) != 0) overrun_ = false;
      if ((value & 32) != 0 && !fifo_.empty()) fifo_.pop_front();
      break;
    case 0x14:
      only(value, kTransmitInterrupt | kReceiveInterrupt | kBusOffInterrupt | kErrorInterrupt, "IER");
      ier_ = value;
      break;
    case 0x18:
      break;
    case 0x1C:
      if ((mcr_ & kInit) == 0)
        world_.report(Misuse::protocol, name() + " bit timing is written outside the initialisation mode");
      only(value, 0x037F03FF, "BTR");
      btr_ = value;
      break;
    default:
      return unmodelled_write(offset, value);
  }
  update();
}

}  // namespace finemote::emulator
