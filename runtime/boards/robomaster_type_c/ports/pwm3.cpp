// PWM header 3: TIM1 channel 3 at PE13.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim1}, stm32f407::rcc::kApb2Tim1, 3, {'E', 13}, 1};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm3{hardware};

}  // namespace finemote
