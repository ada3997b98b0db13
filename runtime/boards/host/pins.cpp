#include "runtime/boards/host/pins.hpp"

namespace finemote {

void PwmPort::start(Duration period) { hardware_->period = period; }
void PwmPort::write(std::uint32_t pulse) { hardware_->writes.push_back({now(), pulse}); }

void GpioPort::start() {}
void GpioPort::write(std::uint8_t pin, bool high) { hardware_->levels[pin] = high; }
bool GpioPort::read(std::uint8_t pin) const { return hardware_->levels[pin]; }

}  // namespace finemote
