#include "runtime/boards/host/ports/pins.hpp"

namespace finemote {

namespace host {
GpioHardware gpio;
}  // namespace host

GpioPort ports::gpio{host::gpio};

void PwmPort::start(Duration period) { hardware_->period = period; }
void PwmPort::write(std::uint32_t pulse) { hardware_->writes.push_back({now(), pulse}); }

bool PwmPort::tune(std::uint32_t period) {
  if (!hardware_->alone) return false;
  hardware_->period = period;
  return true;
}

void GpioPort::configure(std::uint8_t pin, PinSetting setting) {
  hardware_->settings[pin] = setting;
  hardware_->levels[pin] = setting == PinSetting::kInputPullUp || setting == PinSetting::kOutputHigh;
}
void GpioPort::write(std::uint8_t pin, bool high) { hardware_->levels[pin] = high; }
bool GpioPort::read(std::uint8_t pin) const {
  const auto found = hardware_->levels.find(pin);
  return found != hardware_->levels.end() && found->second;
}

void EdgePort::start(bool falling) {
  hardware_->started = true;
  hardware_->falling = falling;
}
Edge EdgePort::last() const { return hardware_->last; }

void AdcPort::start(std::uint8_t input, std::uint8_t) { hardware_->started = input; }
void AdcPort::begin(std::uint8_t input) {
  if (hardware_->converting || hardware_->broken) return;
  hardware_->converting = true;
  hardware_->input = input;
  hardware_->ready_at = now() + AdcHardware::kConversion;
  hardware_->value = hardware_->codes[input];
}
bool AdcPort::take(std::uint8_t input, std::uint16_t& value) {
  if (!hardware_->converting || hardware_->input != input || now() < hardware_->ready_at) return false;
  hardware_->converting = false;
  value = hardware_->value;
  return true;
}

}  // namespace finemote
