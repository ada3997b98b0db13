#include "emulator/chip/i2c.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kOn = 1, kStart = 1U << 8, kStop = 1U << 9, kAck = 1U << 10, kPos = 1U << 11,
                        kSoftReset = 1U << 15;
constexpr std::uint32_t kSb = 1, kAddr = 2, kBtf = 4, kRxne = 64, kTxe = 128, kBerr = 1U << 8, kArlo = 1U << 9,
                        kAf = 1U << 10, kOvr = 1U << 11;
constexpr std::uint32_t kBufferInterrupt = 1U << 10, kDma = 1U << 11, kLastByDma = 1U << 12;  // CR2: RM0090 27.6.2
constexpr std::uint32_t kErrors = kBerr | kArlo | kAf | kOvr;
constexpr std::uint32_t kMaster = 1, kBusy = 2, kTransmitter = 4;
}  // namespace

void I2c::reset() {
  cr1_ = cr2_ = oar1_ = oar2_ = sr1_ = sr2_ = ccr_ = fltr_ = 0;
  trise_ = 2;
  state_ = State::idle;
  data_full_ = shift_full_ = last_comes_ = false;
  ++token_;
  update();
}

std::uint32_t I2c::bus_hz() const {
  const std::uint32_t count = ccr_ & 0xFFF, clock = wiring_.clock_hz();
  if (count == 0) return 100'000;
  const std::uint32_t factor = (ccr_ >> 15 & 1) == 0 ? 2 : (ccr_ >> 14 & 1) == 0 ? 3 : 25;
  return clock / (count * factor);
}

void I2c::update() {
  const bool buffer = (cr2_ & kBufferInterrupt) != 0 && (sr1_ & (kTxe | kRxne)) != 0;
  world_.set_line(wiring_.event_line, (cr2_ >> 9 & 1) != 0 && ((sr1_ & (kSb | kAddr | kBtf)) != 0 || buffer));
  world_.set_line(wiring_.error_line, (cr2_ >> 8 & 1) != 0 && (sr1_ & kErrors) != 0);
}

/// Data go by DMA once the address was sent: RM0090 27.3.7. With LAST the byte after the last but one is not
/// acknowledged.
void I2c::ask_dma() {
  const bool sends = (sr2_ & kTransmitter) != 0 && (sr1_ & kAddr) == 0;
  if ((cr2_ & kDma) == 0 || asking_) return;
  asking_ = true;
  while (sends && (sr1_ & kTxe) != 0 && !data_full_ && wiring_.dma(wiring_.tx)) {}
  while (!sends && (sr1_ & kRxne) != 0 && wiring_.dma(wiring_.rx))
    last_comes_ = (cr2_ & kLastByDma) != 0 && wiring_.dma_left(wiring_.rx) == 1;
  asking_ = false;
}

void I2c::clock(unsigned count, void (I2c::*what)(), Time longer) {
  statistics_.busy += bits(count);
  world_.after(bits(count) + longer, [this, token = ++token_, what] {
    if (token == token_) {
      (this->*what)();
      ask_dma();
      update();
    }
  });
}

void I2c::write_cr1(std::uint32_t value) {
  only(value, kOn | kStart | kStop | kAck | kPos | kSoftReset | 0x80, "CR1");
  if ((value & kSoftReset) != 0) {
    reset();
    cr1_ = kSoftReset;
    return;
  }
  if ((cr1_ & (kStart | kStop)) != 0 && (value & kOn) != 0)
    world_.report(Misuse::protocol, name() + " CR1 is written while a START or STOP is pending");
  const std::uint32_t rising = value & ~cr1_;
  cr1_ = value;
  if ((value & kOn) == 0) {  // off: flags cleared, lines released
    sr1_ = sr2_ = 0;
    cr1_ &= ~(kStart | kStop);
    state_ = State::idle;
    data_full_ = shift_full_ = false;
    ++token_;
    return;
  }
  if ((rising & kStop) != 0) request_stop();
  if ((rising & kStart) != 0) request_start();
}

void I2c::request_start() {
  if (line.sda_held() || !line.scl()) return;  // the bus looks busy: the START waits, for ever perhaps
  if ((cr2_ & 0x3F) != wiring_.clock_hz() / 1'000'000)
    world_.report(Misuse::protocol, name() + " FREQ is not its clock");
  const bool repeated = (sr2_ & kMaster) != 0;
  if (repeated && state_ != State::send_wait && state_ != State::receive_wait) return;  // after the byte under way
  sr1_ &= ~(kBtf | kTxe);
  go(State::starting);
  clock(repeated ? 2 : 1, &I2c::start_done);
}

void I2c::start_done() {
  if ((sr2_ & kBusy) == 0) {
    ++statistics_.transfers;
    moved_ = 0;
  }
  cr1_ &= ~kStart;
  if (lost_starts != 0) {  // back to slave mode; the other master is soon done: RM0090 27.3.4
    --lost_starts;
    sr2_ = 0;
    fail(kArlo);
    return go(State::idle);
  }
  sr2_ |= kMaster | kBusy;
  sr2_ &= ~kTransmitter;
  sr1_ |= kSb;
  if (disturbed_starts != 0) {
    --disturbed_starts;
    sr1_ |= kBerr;
  }
  data_full_ = shift_full_ = sb_seen_ = false;
  byte_index_ = 0;
  go(State::started);
}

void I2c::address_done() {
  reading_ = (shift_ & 1) != 0;
  const bool answered = line.select(static_cast<std::uint8_t>(shift_.value >> 1), reading_);
  tell("address", shift_, answered);
  address_ = shift_.value >> 1U;
  if (answered) {
    sr1_ |= kAddr;
    if (!reading_) sr2_ |= kTransmitter;
    addr_seen_ = false;
    go(State::addressed);
    return;
  }
  fail(kAf);
  go(State::send_wait);
}

/// SR1 and SR2 were read: the flag goes and the clock runs on.
void I2c::leave_addressed() {
  sr1_ &= ~kAddr;
  if (reading_) {
    is_single_ = (cr1_ & (kAck | kPos)) == 0;
    begin_receive();
    if (is_single_ && !world_.cpu().masks_interrupts()) pause();
  } else {
    sr1_ |= kTxe;
    go(State::send_wait);
    if ((cr1_ & kStop) != 0) begin_stop();
  }
}

/// Something more urgent runs first, on a chip that is so.
void I2c::pause() {
  const Time time = from_ns(std::uint64_t{world_.silicon().draw_or_zero(Strictness::i2c_pause)} * 1'000);
  world_.cpu().add_wait(static_cast<unsigned>(time / world_.system().clock().period()));
}

void I2c::begin_send() {
  shift_ = data_;
  data_full_ = false;
  sr1_ |= kTxe;
  sr1_ &= ~kBtf;
  go(State::sending);
  clock(9, &I2c::byte_sent);
}

void I2c::byte_sent() {
  ++statistics_.bytes;
  ++moved_;
  const bool taken = line.write(shift_);
  tell("write", shift_, taken);
  if (!taken) {
    fail(kAf);
    go(State::send_wait);
    return;
  }
  if ((cr1_ & kStop) != 0 && !data_full_) return begin_stop();
  if (data_full_) return begin_send();
  sr1_ |= kTxe | kBtf;
  go(State::send_wait);
  if ((cr1_ & kStart) != 0) request_start();
}

void I2c::begin_receive() {
  go(State::receiving);
  clock(9, &I2c::byte_received);
}

void I2c::byte_received() {
  ++statistics_.bytes;
  ++moved_;
  const WireByte byte = line.read();
  // POS: the bit speaks of the next byte, so the present one is acknowledged (RM0090 27.6.1).
  last_acknowledged_ = (cr1_ & kPos) != 0 && byte_index_ == 0 ? true : (cr1_ & kAck) != 0 && !last_comes_;
  last_comes_ = false;
  ++byte_index_;
  tell("read", byte, last_acknowledged_);
  if ((sr1_ & kRxne) == 0) {
    data_ = byte;
    sr1_ |= kRxne;
  } else {
    shift_ = byte;
    shift_full_ = true;
    sr1_ |= kBtf;
  }
  go(State::receive_wait);
  if (!last_acknowledged_) {
    if (is_single_ && (cr1_ & (kStop | kStart)) == 0)
      world_.report(Misuse::protocol, name() + " STOP of a one-byte read is asked for after its byte: RM0090 27.3.3");
    if ((cr1_ & kStop) != 0) begin_stop();
    return;
  }
  if ((cr1_ & kStop) != 0) world_.report(Misuse::wire, name() + " sends STOP after a byte it acknowledged");
  if (!shift_full_) begin_receive();
}

void I2c::read_data() {
  if ((sr2_ & kTransmitter) != 0) {
    sr1_ &= ~kBtf;  // any access to DR clears it: RM0090 27.6.6
    return;
  }
  sr1_ &= ~(kRxne | kBtf);
  if (!shift_full_) return;
  data_ = shift_;
  shift_full_ = false;
  sr1_ |= kRxne;
  if (state_ == State::receive_wait && last_acknowledged_ && (cr1_ & kStop) == 0) begin_receive();
}

void I2c::request_stop() {
  if ((sr2_ & kMaster) == 0) {
    cr1_ &= ~kStop;
    return;
  }
  const bool waits =
      state_ == State::send_wait || (state_ == State::receive_wait && (shift_full_ || !last_acknowledged_));
  if (waits || state_ == State::started) begin_stop();
}

void I2c::begin_stop() {
  go(State::stopping);
  clock(1, &I2c::stop_done, from_ns(world_.silicon().draw_or_zero(Strictness::i2c_stop)));
}

void I2c::stop_done() {
  line.stop();
  tell("stop", 0, true);
  ++statistics_.lengths[{address_, moved_}];
  cr1_ &= ~kStop;
  sr2_ = 0;
  sr1_ &= ~(kTxe | kBtf | kSb | kAddr);
  if (shift_full_) sr1_ |= kBtf;
  go(State::idle);
  if ((cr1_ & kStart) != 0) request_start();
}

void I2c::fail(std::uint32_t error) {
  sr1_ |= error;
  sr1_ &= ~kTxe;
  ++statistics_.errors;
}

std::uint32_t I2c::read(std::uint32_t offset) {
  std::uint32_t result = 0;
  switch (offset) {
    case 0x00:
      return cr1_;
    case 0x04:
      return cr2_;
    case 0x08:
      return oar1_;
    case 0x0C:
      return oar2_;
    case 0x10:
      result = data_.value;
      world_.crossing()[0] = data_.tag;
      read_data();
      break;
    case 0x14:
      addr_seen_ = addr_seen_ || (sr1_ & kAddr) != 0;
      sb_seen_ = sb_seen_ || (sr1_ & kSb) != 0;
      return sr1_;
    case 0x18:
      result = sr2_ | (line.sda_held() ? kBusy : 0);
      if ((sr1_ & kAddr) != 0 && addr_seen_) leave_addressed();
      ask_dma();
      break;
    case 0x1C:
      return ccr_;
    case 0x20:
      return trise_;
    case 0x24:
      return fltr_;
    default:
      return unmodelled_read(offset);
  }
  update();
  return result;
}

void I2c::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      write_cr1(value);
      break;
    case 0x04:
      only(value, 0x1F3F, "CR2");
      cr2_ = value;
      break;
    case 0x08:
      oar1_ = value;
      break;
    case 0x0C:
      oar2_ = value;
      break;
    case 0x10:
      if (state_ == State::started) {
        if (!sb_seen_) world_.report(Misuse::protocol, name() + " address is written before SR1 was read");
        sr1_ &= ~kSb;
        shift_ = static_cast<std::uint8_t>(value);
        go(State::addressing);
        clock(9, &I2c::address_done);
      } else if ((sr2_ & kTransmitter) != 0) {
        data_ = {static_cast<std::uint8_t>(value), world_.crossing()[0]};
        data_full_ = true;
        sr1_ &= ~(kTxe | kBtf);
        if (state_ == State::send_wait) begin_send();
      } else {
        world_.report(Misuse::protocol, name() + " DR is written outside a transfer");
      }
      break;
    case 0x14:
      sr1_ &= value | ~kErrors;
      break;
    case 0x1C:
    case 0x20:
      if (on()) world_.report(Misuse::protocol, name() + " timing is set while it is on");
      only(value, offset == 0x1C ? 0xCFFF : 0x3F, offset == 0x1C ? "CCR" : "TRISE");
      (offset == 0x1C ? ccr_ : trise_) = value;
      break;
    case 0x24:
      fltr_ = value;
      break;
    default:
      return unmodelled_write(offset);
  }
  ask_dma();
  update();
}

}  // namespace finemote::emulator
