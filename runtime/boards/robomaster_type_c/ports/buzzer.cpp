// Buzzer: TIM4 channel 3 at PD14.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{
    {stm32f407::timer::kTim4}, stm32f407::rcc::kApb1Tim4, 3, {'D', 14}, 2, true};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::buzzer{hardware};

}  // namespace finemote
