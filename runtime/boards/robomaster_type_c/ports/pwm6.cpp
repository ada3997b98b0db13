// PWM header 6: TIM8 channel 2 at PI6.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim8}, stm32f407::rcc::kApb2Tim8, 2, {'I', 6}, 3};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm6{hardware};

}  // namespace finemote
