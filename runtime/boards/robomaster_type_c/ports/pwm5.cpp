// PWM header 5: TIM8 channel 1 at PC6.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim8}, stm32f407::rcc::kApb2Tim8, 1, {'C', 6}, 3};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::pwm5{hardware};

}  // namespace finemote
