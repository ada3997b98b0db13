// PWM header 4: TIM1 channel 4 at PE14.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim1}, stm32f407::rcc::kApb2Tim1, 4, {'E', 14}, 1};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm4{hardware};

}  // namespace finemote
