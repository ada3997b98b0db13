// Pulses, pins, edges and voltages without a world: nobody sees the outputs, inputs read as configured, nothing is
// measured.
#include "runtime/boards/qemu_f405/ports/outputs.hpp"

namespace finemote {

namespace {

GpioHardware pins;

}  // namespace

GpioPort ports::gpio{pins};

void PwmPort::start(Duration) {}
void PwmPort::write(std::uint32_t pulse) { hardware_->pulse = pulse; }

bool PwmPort::tune(std::uint32_t) { return true; }

void GpioPort::configure(std::uint8_t pin, PinSetting setting) {
  write(pin, setting == PinSetting::kInputPullUp || setting == PinSetting::kOutputHigh);
}
void GpioPort::write(std::uint8_t pin, bool high) {
  std::uint32_t& word = hardware_->levels[pin / 32];
  word = high ? word | 1U << pin % 32 : word & ~(1U << pin % 32);
}
bool GpioPort::read(std::uint8_t pin) const { return (hardware_->levels[pin / 32] >> pin % 32 & 1U) != 0; }

void EdgePort::start(bool) {}
Edge EdgePort::last() const { return {}; }

void AdcPort::start(std::uint8_t, std::uint8_t) {}
void AdcPort::begin(std::uint8_t) {}
bool AdcPort::take(std::uint8_t, std::uint16_t&) { return false; }

}  // namespace finemote
