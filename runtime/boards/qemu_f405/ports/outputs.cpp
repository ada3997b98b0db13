// PwmPort and GpioPort without pins: nobody sees the outputs, inputs read low.
#include "finemote/ports.hpp"

namespace finemote {

struct PwmHardware {
  std::uint32_t pulse = 0;
};

struct GpioHardware {
  std::uint32_t levels[8]{};
};

namespace {

PwmHardware pwm[7];
GpioHardware pins;

}  // namespace

PwmPort ports::pwm1{pwm[0]};
PwmPort ports::pwm2{pwm[1]};
PwmPort ports::pwm3{pwm[2]};
PwmPort ports::pwm4{pwm[3]};
PwmPort ports::pwm5{pwm[4]};
PwmPort ports::pwm6{pwm[5]};
PwmPort ports::pwm7{pwm[6]};
GpioPort ports::gpio{pins};

void PwmPort::start(Duration) {}
void PwmPort::write(std::uint32_t pulse) { hardware_->pulse = pulse; }

void GpioPort::start() {}
void GpioPort::write(std::uint8_t pin, bool high) {
  std::uint32_t& word = hardware_->levels[pin / 32];
  word = high ? word | 1U << pin % 32 : word & ~(1U << pin % 32);
}
bool GpioPort::read(std::uint8_t pin) const { return (hardware_->levels[pin / 32] >> pin % 32 & 1U) != 0; }

}  // namespace finemote
