// Pulses, pins, edges and voltages without a world: nobody sees the outputs, inputs read as configured, nothing is
// measured.
#include "finemote/ports.hpp"

namespace finemote {

struct PwmHardware {
  std::uint32_t pulse = 0;
};

struct GpioHardware {
  std::uint32_t levels[8]{};
};

struct EdgeHardware {};
struct AdcHardware {};

namespace {

PwmHardware pwm[12];
GpioHardware pins;
EdgeHardware edges;
AdcHardware converter;

}  // namespace

PwmPort ports::pwm1{pwm[0]};
PwmPort ports::pwm2{pwm[1]};
PwmPort ports::pwm3{pwm[2]};
PwmPort ports::pwm4{pwm[3]};
PwmPort ports::pwm5{pwm[4]};
PwmPort ports::pwm6{pwm[5]};
PwmPort ports::pwm7{pwm[6]};
PwmPort ports::led_red{pwm[7]};
PwmPort ports::led_green{pwm[8]};
PwmPort ports::led_blue{pwm[9]};
PwmPort ports::buzzer{pwm[10]};
PwmPort ports::imu_heater{pwm[11]};
GpioPort ports::gpio{pins};
EdgePort ports::exti0{edges};
EdgePort ports::exti3{edges};
EdgePort ports::exti4{edges};
EdgePort ports::exti5{edges};
AdcPort ports::adc3{converter};

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
