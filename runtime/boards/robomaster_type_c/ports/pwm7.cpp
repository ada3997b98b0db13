// PWM header 7: TIM8 channel 3 at PI7.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim8}, stm32f407::rcc::kApb2Tim8, 3, {'I', 7}, 3};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm7{hardware};

}  // namespace finemote
