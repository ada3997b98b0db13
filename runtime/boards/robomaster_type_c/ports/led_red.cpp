// Red part of the RGB LED: TIM5 channel 3 at PH12.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{
    {stm32f407::timer::kTim5}, stm32f407::rcc::kApb1Tim5, 3, {'H', 12}, 2, true};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::led_red{hardware};

}  // namespace finemote
