// PWM header 2: TIM1 channel 2 at PE11.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim1}, stm32f407::rcc::kApb2Tim1, 2, {'E', 11}, 1};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm2{hardware};

}  // namespace finemote
