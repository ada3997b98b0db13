// Heater of the BMI088: TIM10 channel 1 at PF6.
#include "runtime/boards/robomaster_type_c/ports/pwm_hardware.hpp"
#include "runtime/boards/robomaster_type_c/registers/clock.hpp"

namespace finemote {
namespace {

constexpr robomaster_type_c::PwmSetup kSetup{{stm32f407::timer::kTim10}, stm32f407::rcc::kApb2Tim10, 1, {'F', 6}, 3};
PwmHardware hardware{kSetup};

}  // namespace

PwmPort ports::imu_heater{hardware};

}  // namespace finemote
