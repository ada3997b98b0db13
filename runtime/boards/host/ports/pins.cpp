#include "runtime/boards/host/ports/pins.hpp"

namespace finemote {

namespace host {
PwmHardware pwm1, pwm2, pwm3, pwm4, pwm5, pwm6, pwm7;
GpioHardware gpio;
}  // namespace host

namespace ports {
PwmPort pwm1{host::pwm1}, pwm2{host::pwm2}, pwm3{host::pwm3}, pwm4{host::pwm4};
PwmPort pwm5{host::pwm5}, pwm6{host::pwm6}, pwm7{host::pwm7};
GpioPort gpio{host::gpio};
}  // namespace ports

void PwmPort::start(Duration period) { hardware_->period = period; }
void PwmPort::write(std::uint32_t pulse) { hardware_->writes.push_back({now(), pulse}); }

void GpioPort::start() {}
void GpioPort::write(std::uint8_t pin, bool high) { hardware_->levels[pin] = high; }
bool GpioPort::read(std::uint8_t pin) const { return hardware_->levels[pin]; }

}  // namespace finemote
