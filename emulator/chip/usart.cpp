#include "emulator/chip/usart.hpp"

#include <cmath>

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kParity = 1, kFraming = 2, kNoise = 4, kOverrun = 8, kIdle = 16, kReceived = 32, kComplete = 64,
                        kEmpty = 128;
constexpr std::uint32_t kReceiver = 4, kIdleInterrupt = 16, kReceivedInterrupt = 32, kCompleteInterrupt = 64,
                        kEmptyInterrupt = 128, kParityInterrupt = 256, kOddParity = 512, kParityOn = 1024,
                        kNineBits = 4096;
constexpr std::uint32_t kErrorInterrupt = 1, kDmaReceive = 64, kDmaTransmit = 128;
constexpr double kTolerance = 0.03;  // RM0090 30.3.5: receiver tolerance about 3 to 4 %
}  // namespace

void Usart::reset() {
  sr_ = 0xC0;
  brr_ = cr1_ = cr2_ = cr3_ = gtpr_ = 0;
  data_full_ = shifting_ = status_read_ = false;
  ++idle_token_;
  update();
}

/// Clocks of a bit: BRR counts sixteenths of 16 samples, or with OVER8 eighths of 8 (RM0090 30.3.4).
std::uint32_t Usart::divider() const { return (cr1_ >> 15 & 1) == 0 ? brr_ : (brr_ >> 4) * 8 + (brr_ & 7); }

SerialFormat Usart::format() const {
  SerialFormat format;
  format.baud = divider() == 0 ? 1 : wiring_.clock_hz() / divider();
  const bool parity = (cr1_ & kParityOn) != 0, odd = (cr1_ & kOddParity) != 0;
  format.even_parity = parity && !odd;
  format.odd_parity = parity && odd;
  format.data_bits = ((cr1_ & kNineBits) != 0 ? 9 : 8) - (parity ? 1 : 0);  // RM0090 30.3.7, table 147
  format.stop_bits = (cr2_ >> 12 & 3) == 2 ? 2 : 1;
  return format;
}

BusStatistics Usart::statistics() const {
  return BusStatistics{bursts_, in_bytes_ + out_bytes_, errors_, out_busy_, in_busy_};
}

void Usart::update() {
  bool high = ((cr1_ & kIdleInterrupt) != 0 && (sr_ & kIdle) != 0) ||
              ((cr1_ & kReceivedInterrupt) != 0 && (sr_ & (kReceived | kOverrun)) != 0) ||
              ((cr1_ & kCompleteInterrupt) != 0 && (sr_ & kComplete) != 0);
  high = high || ((cr1_ & kEmptyInterrupt) != 0 && (sr_ & kEmpty) != 0) ||
         ((cr1_ & kParityInterrupt) != 0 && (sr_ & kParity) != 0);
  high = high ||
         ((cr3_ & kErrorInterrupt) != 0 && (cr3_ & kDmaReceive) != 0 && (sr_ & (kFraming | kNoise | kOverrun)) != 0);
  world_.set_line(wiring_.line, high && on());
}

void Usart::ask_dma() {
  if ((cr3_ & kDmaReceive) != 0 && (sr_ & kReceived) != 0) wiring_.dma(wiring_.rx);
  while (sends() && (cr3_ & kDmaTransmit) != 0 && (sr_ & kEmpty) != 0) {
    if (!wiring_.dma(wiring_.tx)) break;
  }
}

void Usart::send_in(const std::vector<std::uint8_t>& bytes, const SerialFormat& sender, Tag sample) {
  ++driven_;
  Time at = in_free_at_ > world_.now() ? in_free_at_ : world_.now();
  if (at == world_.now() || in_free_at_ < world_.now()) ++bursts_;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    at += sender.byte_time();
    const Arrival arrival{{bytes[i], i + 1 == bytes.size() ? sample : Tag::none}, i == 0};
    world_.at(at, [this, arrival, sender] { arrive(arrival, sender); });
  }
  in_busy_ += bytes.size() * sender.byte_time();
  in_free_at_ = at;
}

void Usart::arrive(const Arrival& arrival, const SerialFormat& sender) {
  WireByte byte = arrival.byte;
  const bool heard = !silent && on() && (cr1_ & kReceiver) != 0;
  spoilt_ = (spoilt_ && !arrival.is_first) || !heard;
  if (!silent) ++in_bytes_;
  if (!heard) return;
  const SerialFormat mine = format();
  const Sampled sampled = sample(byte, sender);
  std::uint32_t errors = sampled.errors;
  if (noisy_bytes != 0) {
    --noisy_bytes;
    errors |= kNoise | kFraming;
    byte.value ^= 0x55;
  }
  if (errors != 0) ++errors_;
  const bool overrun = (sr_ & kReceived) != 0;
  spoilt_ = spoilt_ || errors != 0 || overrun;
  if (overrun) {
    sr_ |= kOverrun;
    ++errors_;
  } else {
    received_ = {byte.value, spoilt_ ? Tag::none : byte.tag};
    ninth_ = sampled.ninth;
    sr_ |= kReceived;
  }
  sr_ |= errors;
  if ((cr3_ & kDmaReceive) != 0) wiring_.dma(wiring_.rx);
  // An idle frame after the last stop bit: RM0090 30.3.3.
  ++idle_token_;
  const Time idle_at = world_.now() + mine.byte_time();
  world_.at(idle_at, [this, token = idle_token_, idle_at] { line_idle(token, idle_at); });
  update();
}

/// What the receiver makes of the bits of one byte. The sender's are eight, a parity bit where it has one, and a stop
/// bit; the receiver takes eight or nine, of which with parity the last is checked, and then expects a stop bit. So it
/// gets all eight also where it takes the last one for a parity bit.
Usart::Sampled Usart::sample(unsigned byte, const SerialFormat& sender) {
  const SerialFormat mine = format();
  const bool rate_wrong = std::abs(double(sender.baud) / mine.baud - 1) > kTolerance;
  const bool format_wrong = sender.even_parity != mine.even_parity || sender.odd_parity != mine.odd_parity ||
                            sender.data_bits != mine.data_bits;
  const unsigned tenth = sender.has_parity() ? sender.parity_of(byte) : 1;  // else the stop bit
  const bool nine = (cr1_ & kNineBits) != 0;
  if (rate_wrong || (format_wrong && !nine) || (format_wrong && mine.has_parity()))
    world_.report(Misuse::wire, name() + " listens in another rate or format than is sent");
  std::uint32_t errors = rate_wrong ? kFraming | kNoise : 0;
  if (mine.has_parity()) {
    const unsigned checked = nine ? tenth : byte >> 7 & 1, over = nine ? byte : byte & 0x7F;
    if (checked != mine.parity_of(over)) errors |= kParity;
  }
  if (!nine && tenth == 0) errors |= kFraming;  // a parity bit where the stop bit should be
  return {nine ? tenth : 0, errors};
}

void Usart::line_idle(std::uint64_t token, Time at) {
  if (token != idle_token_ || in_free_at_ >= at) return;  // the core may be later than that, and a byte still to come
  sr_ |= kIdle;
  update();
}

std::uint32_t Usart::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      status_read_ = true;
      return sr_;
    case 0x04:
      if (status_read_) sr_ &= ~(kParity | kFraming | kNoise | kOverrun | kIdle);
      status_read_ = false;
      sr_ &= ~kReceived;
      update();
      world_.crossing()[0] = received_.tag;
      return received_.value | ninth_ << 8;  // with parity it is the last bit, as received: RM0090 30.6.2
    case 0x08:
      return brr_;
    case 0x0C:
      return cr1_;
    case 0x10:
      return cr2_;
    case 0x14:
      return cr3_;
    case 0x18:
      return gtpr_;
    default:
      return unmodelled_read(offset);
  }
}

void Usart::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      sr_ &= value | ~(kComplete | kReceived);
      break;  // rc_w0 bits
    case 0x04:
      if (!sends()) {
        world_.report(Misuse::protocol, name() + " is given a byte while its transmitter is off");
        return;
      }
      if (status_read_) sr_ &= ~kComplete;
      if (data_full_) world_.report(Misuse::protocol, name() + " is given a byte before the last one left");
      to_send_ = {sent_bits(value), world_.crossing()[0]};
      data_full_ = true;
      sr_ &= ~kEmpty;
      if (!shifting_) start_shift();
      break;
    case 0x08:
      brr_ = value & 0xFFFF;
      break;
    case 0x0C:
      write_cr1(value);
      break;
    case 0x10:
      only(value, 0x2000, "CR2");  // one stop bit or two
      cr2_ = value;
      break;
    case 0x14:
      only(value, kErrorInterrupt | kDmaReceive | kDmaTransmit | 0x800, "CR3");
      cr3_ = value;
      break;
    case 0x18:
      gtpr_ = value;
      break;
    default:
      return unmodelled_write(offset);
  }
  update();
  if (offset == 0x0C || offset == 0x14) ask_dma();
  update();
}

/// With seven bits the parity takes the place of the eighth.
std::uint8_t Usart::sent_bits(std::uint32_t value) const {
  const SerialFormat mine = format();
  const std::uint32_t byte = value & 0xFF;
  return static_cast<std::uint8_t>(mine.data_bits == 7 ? (byte & 0x7F) | mine.parity_of(byte & 0x7F) << 7 : byte);
}

void Usart::write_cr1(std::uint32_t value) {
  only(value, 0xB7FC, "CR1");  // no break, no mute mode
  const bool sent = sends(), heard = on() && (cr1_ & kReceiver) != 0;
  cr1_ = value;
  const unsigned bits = format().data_bits;
  if (on() && bits != 8)
    world_.report(Misuse::wire, name() + (bits == 9 ? " nine data bits: there is no parity bit among them"
                                                    : " seven data bits: the parity is one of the eight"));
  if (!sent && sends() && !shifting_) idle_frame();
  if (!heard && on() && (cr1_ & kReceiver) != 0) hear_noise();
}

/// What some lines bring a receiver that is turned on, until the other side drives them.
void Usart::hear_noise() {
  const std::uint32_t bytes = world_.silicon().draw_or_zero(Strictness::first_bytes);
  const SerialFormat mine = format();
  for (std::uint32_t i = 1; i <= bytes; ++i) {
    world_.after(i * mine.byte_time(), [this, mine, token = driven_] {
      if (token != driven_) return;
      ++noisy_bytes;
      arrive({{0xFE, Tag::none}, true}, mine);
    });
  }
}

/// What a transmitter sends first when it is turned on: RM0090 30.3.2.
void Usart::idle_frame() {
  shifting_ = true;
  world_.after(format().byte_time(), [this] {
    if (!shifting_) return;  // reset meanwhile
    shifting_ = false;
    if (data_full_) start_shift();
    update();
  });
}

void Usart::start_shift() {
  const Time duration = format().byte_time();
  shifting_ = true;
  data_full_ = false;
  sr_ &= ~kComplete;
  sr_ |= kEmpty;
  if (out_last_ != world_.now()) ++bursts_;
  out_busy_ += duration;
  world_.after(duration, [this, byte = to_send_] { shifted(byte); });
}

void Usart::shifted(WireByte byte) {
  if (!shifting_) return;  // reset meanwhile
  shifting_ = false;
  out_last_ = world_.now();
  ++out_bytes_;
  if (data_full_) {
    start_shift();
  } else {
    if ((cr3_ & kDmaTransmit) != 0) ask_dma();
    if (!shifting_) sr_ |= kComplete;
  }
  if (on_sent) on_sent(byte);
  if ((cr3_ & kDmaTransmit) != 0) ask_dma();
  update();
}

}  // namespace finemote::emulator
