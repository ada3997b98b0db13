#include "emulator/chip/iwdg.hpp"

namespace finemote::emulator {

void Iwdg::reset() {
  prescaler_ = 0;
  reload_ = 0xFFF;
  running_ = unlocked_ = false;
  ++token_;
}

void Iwdg::feed() {
  const Time period = (Time{reload_} + 1) * (Time{4} << (prescaler_ > 6 ? 6 : prescaler_)) * period_of(lsi_hz);
  ++token_;
  world_.after(period, [this, token = token_] {
    if (token == token_ && on_timeout) on_timeout();
  });
}

std::uint32_t Iwdg::read(std::uint32_t offset) {
  switch (offset) {
    case 0x0:
      return 0;
    case 0x4:
      return prescaler_;
    case 0x8:
      return reload_;
    case 0xC:
      return world_.now() < busy_until_ ? 3 : 0;
    default:
      return unmodelled_read(offset);
  }
}

void Iwdg::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x0:
      unlocked_ = value == 0x5555;
      if (value == 0xCCCC) running_ = true;
      if (running_ && (value == 0xAAAA || value == 0xCCCC)) feed();
      return;
    case 0x4:
    case 0x8:
      if (!unlocked_) return world_.report(Misuse::protocol, "iwdg is written without its key");
      (offset == 0x4 ? prescaler_ : reload_) = value & (offset == 0x4 ? 7 : 0xFFF);
      busy_until_ = world_.now() + 5 * period_of(lsi_hz);
      return;
    default:
      return unmodelled_write(offset);
  }
}

}  // namespace finemote::emulator
