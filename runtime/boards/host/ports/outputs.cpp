// PwmPort and GpioPort on the host: values somebody may look at.
#include "finemote/host_ports.hpp"
#include "finemote/ports.hpp"

namespace finemote {

struct PwmHardware {
  std::uint32_t pulse = 0;
};

struct GpioHardware {
  bool levels[256]{};
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

void PwmPort::start(Duration) { hardware_->pulse = 0; }
void PwmPort::write(std::uint32_t pulse) { hardware_->pulse = pulse; }

void GpioPort::start() {}
void GpioPort::write(std::uint8_t pin, bool high) { hardware_->levels[pin] = high; }
bool GpioPort::read(std::uint8_t pin) const { return hardware_->levels[pin]; }

namespace host {

std::uint32_t pulse(const PwmPort& port) {
  const PwmPort* const all[] = {&ports::pwm1, &ports::pwm2, &ports::pwm3, &ports::pwm4,
                                &ports::pwm5, &ports::pwm6, &ports::pwm7};
  for (unsigned i = 0; i < 7; ++i) {
    if (all[i] == &port) return pwm[i].pulse;
  }
  return 0;
}

bool pin(const GpioPort&, std::uint8_t number) { return pins.levels[number]; }
void drive_pin(const GpioPort&, std::uint8_t number, bool high) { pins.levels[number] = high; }

}  // namespace host
}  // namespace finemote
