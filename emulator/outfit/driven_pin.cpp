#include "emulator/outfit/driven_pin.hpp"

#include <utility>

namespace finemote::emulator {
namespace {
constexpr unsigned kOutput = 1, kAlternate = 2;  // MODER: RM0090 8.4.1
}  // namespace

Drive drive_of(Timer::Pulse pulse) {
  if (pulse.period_ns == 0) return {};
  const auto width = static_cast<double>(pulse.width_ns), period = static_cast<double>(pulse.period_ns);
  const bool is_steady = pulse.width_ns == 0 || pulse.width_ns >= pulse.period_ns;
  return {width / period, is_steady ? 0 : 1e9 / period};
}

DrivenPin::DrivenPin(Gpio& gpio, unsigned pin) : gpio_(gpio), pin_(pin) {
  gpio.watcher[pin] = [this](bool, bool) { tell(); };
}

void DrivenPin::set_pulse(Timer::Pulse pulse) {
  pulse_ = pulse;
  tell();
}

void DrivenPin::listen(Listener listener) {
  listener(now());
  listeners_.push_back(std::move(listener));
}

Drive DrivenPin::now() const {
  const unsigned mode = gpio_.mode(pin_);
  if (mode == kAlternate) return drive_of(pulse_);
  return mode == kOutput && gpio_.level(pin_) ? Drive{1, 0} : Drive{};
}

void DrivenPin::tell() {
  const Drive drive = now();
  if (drive == last_) return;
  last_ = drive;
  for (const Listener& listener : listeners_) listener(drive);
}

}  // namespace finemote::emulator
