// PWM header 1: TIM1 channel 1 at PE9.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim1}, stm32f407::rcc::kApb2Tim1, 1, {'E', 9}, 1};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm1{hardware};

}  // namespace finemote
