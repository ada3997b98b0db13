#include "runtime/boards/host/ports/pins.hpp"

namespace finemote {

namespace host {
PwmHardware pwm1, pwm2, pwm3, pwm4, pwm5, pwm6, pwm7, led_red, led_green, led_blue, buzzer, imu_heater;
GpioHardware gpio;
EdgeHardware exti0, exti3, exti4, exti5;
AdcHardware adc3;
}  // namespace host

namespace ports {
PwmPort pwm1{host::pwm1}, pwm2{host::pwm2}, pwm3{host::pwm3}, pwm4{host::pwm4};
PwmPort pwm5{host::pwm5}, pwm6{host::pwm6}, pwm7{host::pwm7};
PwmPort led_red{host::led_red}, led_green{host::led_green}, led_blue{host::led_blue};
PwmPort buzzer{host::buzzer}, imu_heater{host::imu_heater};
GpioPort gpio{host::gpio};
EdgePort exti0{host::exti0}, exti3{host::exti3}, exti4{host::exti4}, exti5{host::exti5};
AdcPort adc3{host::adc3};
}  // namespace ports

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
