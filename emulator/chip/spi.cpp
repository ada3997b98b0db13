#include "emulator/chip/spi.hpp"

namespace finemote::emulator {
namespace {
constexpr std::uint32_t kReceived = 1, kEmpty = 2, kOverrun = 64, kBusy = 128;
}

void Spi::reset() {
  cr1_ = cr2_ = 0;
  polynomial_ = 7;
  sr_ = kEmpty;
  full_ = shifting_ = overrun_read_ = ending_ = false;
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
  if (!low && ending_) world_.report(Misuse::wire, name() + " chip select rises before the last edge of the clock");
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
  full_ = ending_ = false;
  sr_ |= kEmpty | kBusy;
  const Time duration = (wide() ? 16 : 8) * period_of(clock_hz());
  statistics_.busy += duration;
  world_.after(duration, [this, out = out_, token = token_] {
    if (token == token_) shifted(out);
  });
}

WireByte Spi::exchange(WireByte out) {
  ++statistics_.bytes;
  WireByte in = 0xFF;
  unsigned answering = 0;
  for (Attached& it : parts_) {
    if (!it.selected) continue;
    in &= it.part.exchange(out);
    ++answering;
    if (it.part.fastest_hz != 0 && clock_hz() > it.part.fastest_hz)
      world_.report(Misuse::wire, name() + " is faster than the part it talks to allows");
  }
  if (answering > 1) world_.report(Misuse::wire, name() + " has two chip selects low");
  return in;
}

void Spi::shifted(const Frame& out) {
  shifting_ = false;
  Frame in;
  if (wide()) in.high = exchange(out.high);
  in.low = exchange(out.low);
  if (on_frame) on_frame(wide() ? out.value() : out.low.value, in.value(), wide() ? 16 : 8);
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
    end_clock();
  }
  ask_dma();
  update();
}

/// BSY falls with the last edge, which on some chips comes later than the sampling of the last bit.
void Spi::end_clock() {
  const std::uint32_t half_bits = world_.silicon().draw_or_zero(Strictness::spi_busy);
  if (half_bits == 0) {
    sr_ &= ~kBusy;
    return;
  }
  ending_ = true;
  world_.after(half_bits * period_of(clock_hz()) / 2, [this, token = token_] {
    if (token != token_) return;
    ending_ = false;
    if (!shifting_) sr_ &= ~kBusy;
  });
}

std::uint32_t Spi::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      return cr1_;
    case 0x04:
      return cr2_;
    case 0x08: {
      const std::uint32_t status = sr_;
      if (overrun_read_) sr_ &= ~kOverrun;  // DR, then SR: RM0090 28.3.10
      overrun_read_ = false;
      update();
      return status;
    }
    case 0x0C:
      overrun_read_ = (sr_ & kOverrun) != 0;
      sr_ &= ~kReceived;
      update();
      world_.crossing() = {in_.low.tag, in_.high.tag};
      return in_.value();
    case 0x10:
      return polynomial_;
    case 0x14:  // the checksums, which are not modelled: CR1 says so where one is asked for
    case 0x18:
    case 0x1C:
      return 0;
    case 0x20:
      return 2;  // I2SPR
    default:
      return unmodelled_read(offset);
  }
}

void Spi::write_cr1(std::uint32_t value) {
  only(value, 0xB7F, "CR1");
  if (on() && (value & 0x40) != 0 && ((value ^ cr1_) & 0x83B) != 0)
    world_.report(Misuse::protocol, name() + " mode or clock is changed while it is on");
  cr1_ = value;
  const bool held_high = (cr1_ & 0x200) != 0 ? (cr1_ & 0x100) != 0 : (cr2_ & 4) != 0;  // SSM: SSI, else SSOE
  if (on() && !held_high)
    world_.report(Misuse::protocol, name() + " sees its own select low: mode fault (RM0090 28.3.10)");
  if ((value & 0x40) != 0) {
    if (full_ && !shifting_) shift();  // kept since it was turned off
    return;
  }
  if (shifting_) world_.report(Misuse::protocol, name() + " is turned off in the middle of a byte");
  if (ending_) world_.report(Misuse::protocol, name() + " is turned off before the last edge of the clock");
  ++token_;
  shifting_ = ending_ = false;
  full_ = full_ && world_.silicon().is(Strictness::spi_kept);
  sr_ = (sr_ & ~(kBusy | kEmpty)) | (full_ ? 0 : kEmpty);
}

void Spi::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      write_cr1(value);
      break;
    case 0x04:
      only(value, 0xE7, "CR2");
      cr2_ = value;
      break;
    case 0x08:
      break;
    case 0x0C:
      if (!on()) return world_.report(Misuse::protocol, name() + " is given a byte while it is off");
      out_ = {{static_cast<std::uint8_t>(value), world_.crossing()[0]},
              {static_cast<std::uint8_t>(value >> 8), world_.crossing()[1]}};
      full_ = true;
      sr_ &= ~kEmpty;
      if (!shifting_) shift();
      break;
    case 0x10:
      polynomial_ = value & 0xFFFF;
      break;
    case 0x1C:
      only(value, 0, "I2SCFGR");
      break;
    default:
      return unmodelled_write(offset);
  }
  if (offset != 0x0C) ask_dma();
  update();
}

}  // namespace finemote::emulator
