#include "emulator/chip/gpio.hpp"

namespace finemote::emulator {

void Gpio::reset() {  // RM0090 8.4: ports A and B hold the debug pins
  moder_ = port_ == 'A' ? 0xA8000000U : port_ == 'B' ? 0x280U : 0;
  ospeedr_ = port_ == 'A' ? 0x0C000000U : port_ == 'B' ? 0xC0U : 0;
  pupdr_ = port_ == 'A' ? 0x64000000U : port_ == 'B' ? 0x100U : 0;
  otyper_ = odr_ = 0;
  afr_ = {};
  changed();  // what drives a pin from outside goes on
}

bool Gpio::level(unsigned pin) const {
  const bool output = mode(pin) == 1, open_drain = (otyper_ >> pin & 1) != 0, high = (odr_ >> pin & 1) != 0;
  if (output && !open_drain) return high;
  bool result = (pupdr_ >> (2 * pin) & 3) == 1;
  if (outside_[pin] >= 0) result = outside_[pin] != 0;
  if (wire[pin]) result = wire[pin]();
  return result && !(output && !high);
}

void Gpio::drive(unsigned pin, int level) {
  outside_[pin] = level;
  changed();
}

void Gpio::changed() {
  const std::uint64_t before = last_drive_;
  for (unsigned pin = 0; pin < 16; ++pin) {
    const bool output = mode(pin) == 1, high = (odr_ >> pin & 1) != 0;
    const std::uint64_t now = mode(pin) << 1 | (high ? 1 : 0), mask = std::uint64_t{7} << (3 * pin);
    last_drive_ = (last_drive_ & ~mask) | now << (3 * pin);
    if (((before ^ last_drive_) & mask) == 0) continue;
    if (watcher[pin]) watcher[pin](output, high);
    if (on_output) on_output(pin, output, high);
  }
  std::uint32_t levels = 0;
  for (unsigned pin = 0; pin < 16; ++pin) levels |= level(pin) ? 1U << pin : 0;
  const std::uint32_t different = levels ^ last_levels_;
  last_levels_ = levels;
  for (unsigned pin = 0; pin < 16 && on_level; ++pin) {
    if ((different >> pin & 1) != 0) on_level(pin, (levels >> pin & 1) != 0);
  }
}

std::uint32_t Gpio::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      return moder_;
    case 0x04:
      return otyper_;
    case 0x08:
      return ospeedr_;
    case 0x0C:
      return pupdr_;
    case 0x10: {
      std::uint32_t levels = 0;
      for (unsigned pin = 0; pin < 16; ++pin) levels |= level(pin) ? 1U << pin : 0;
      return levels;
    }
    case 0x14:
      return odr_;
    case 0x18:
      return 0;
    case 0x1C:
      return 0;
    case 0x20:
      return afr_[0];
    case 0x24:
      return afr_[1];
    default:
      return unmodelled_read(offset);
  }
}

/// Bytes and halfwords are allowed (RM0090 8.4); of BSRR the rest reads as zero.
void Gpio::write_part(std::uint32_t offset, std::uint32_t mask, std::uint32_t value) {
  write(offset, (offset == 0x18 ? 0 : read(offset) & ~mask) | value);
}

void Gpio::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      moder_ = value;
      break;
    case 0x04:
      otyper_ = value & 0xFFFF;
      break;
    case 0x08:
      ospeedr_ = value;
      return;
    case 0x0C:
      pupdr_ = value;
      break;
    case 0x14:
      odr_ = value & 0xFFFF;
      break;
    case 0x18:
      odr_ = (odr_ & ~(value >> 16)) | (value & 0xFFFF);
      break;  // set wins: RM0090 8.4.7
    case 0x20:
      afr_[0] = value;
      return;
    case 0x24:
      afr_[1] = value;
      return;
    default:
      return unmodelled_write(offset);
  }
  changed();
}

}  // namespace finemote::emulator
