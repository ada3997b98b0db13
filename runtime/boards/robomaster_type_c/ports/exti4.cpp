// EXTI4: BMI088 accelerometer data ready, PC4. Line 10: RM0090 12.2, table 62.
#include "runtime/boards/robomaster_type_c/ports/exti_hardware.hpp"

namespace finemote {
namespace {

EdgeHardware hardware{{'C', 4}, 10};

}  // namespace

EdgePort ports::exti4{hardware};

extern "C" void finemote_line_10() { hardware.on_interrupt(); }

}  // namespace finemote
