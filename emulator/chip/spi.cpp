#include "emulator/chip/spi.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kReceived = 1, kEmpty = 2, kOverrun = 64, kBusy = 128;
}

void Spi::reset() {
  cr1_ = cr2_ = 0;
  sr_ = kEmpty;
  full_ = shifting_ = false;
  ++token_;
  update();
}

void Spi::update() {
  const bool high = ((cr2_ & 64) != 0 && (sr_ & kReceived) != 0) || ((cr2_ & 128) != 0 && (sr_ & kEmpty) != 0) ||
                    ((cr2_ & 32) != 0 && (sr_ & kOverrun) != 0);
  world_.set_line(wiring_.line, high);
}

void Spi::selected(std::size_t part, bool low) {
  if (parts_[part].selected == low) return;
  parts_[part].selected = low;
  if (low) ++statistics_.transfers;
  if (!low && shifting_) world_.report(Misuse::wire, name() + " chip select rises in the middle of a byte");
  if (parts_[part].part.select) parts_[part].part.select(low);
}

void Spi::ask_dma() {
  if (!on()) return;
  if ((cr2_ & 1) != 0 && (sr_ & kReceived) != 0) wiring_.dma(wiring_.rx);
  while ((cr2_ & 2) != 0 && (sr_ & kEmpty) != 0) {
    if (!wiring_.dma(wiring_.tx)) break;
  }
}

void Spi::shift() {
  shifting_ = true;
  full_ = false;
  sr_ |= kEmpty | kBusy;
  const Time duration = 8 * period_of(clock_hz());
  statistics_.busy += duration;
  world_.after(duration, [this, out = out_, token = token_] {
    if (token == token_) shifted(out);
  });
}

void Spi::shifted(std::uint8_t out) {
  shifting_ = false;
  ++statistics_.bytes;
  std::uint8_t in = 0xFF;
  unsigned answering = 0;
  for (Attached& it : parts_) {
    if (!it.selected) continue;
    in &= it.part.exchange(out);
    ++answering;
  }
  if (answering > 1) world_.report(Misuse::wire, name() + " has two chip selects low");
  if ((sr_ & kReceived) != 0) {
    sr_ |= kOverrun;
    ++statistics_.errors;
  } else {
    in_ = in;
    sr_ |= kReceived;
  }
  if (full_) {
    shift();
  } else {
    sr_ &= ~kBusy;
  }
  ask_dma();
  update();
}

std::uint32_t Spi::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      return cr1_;
    case 0x04:
      return cr2_;
    case 0x08:
      return sr_;
    case 0x0C:
      sr_ &= ~(kReceived | kOverrun);
      update();
      return in_;
    default:
      return unmodelled_read(offset);
  }
}

void Spi::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      if (on() && (value & 0x40) != 0 && ((value ^ cr1_) & 0x3B) != 0)
        world_.report(Misuse::protocol, name() + " mode or clock is changed while it is on");
      if ((value & 0x800) != 0) world_.report(Misuse::unmodelled, name() + " 16-bit frames");
      cr1_ = value;
      if ((value & 0x40) == 0) {
        if (shifting_) world_.report(Misuse::protocol, name() + " is turned off in the middle of a byte");
        ++token_;
        shifting_ = full_ = false;
        sr_ = (sr_ | kEmpty) & ~kBusy;
      }
      break;
    case 0x04:
      cr2_ = value;
      break;
    case 0x08:
      break;
    case 0x0C:
      if (!on()) return world_.report(Misuse::protocol, name() + " is given a byte while it is off");
      out_ = static_cast<std::uint8_t>(value);
      full_ = true;
      sr_ &= ~kEmpty;
      if (!shifting_) shift();
      break;
    default:
      return unmodelled_write(offset, value);
  }
  if (offset != 0x0C) ask_dma();
  update();
}

}  // namespace finemote::emulator
