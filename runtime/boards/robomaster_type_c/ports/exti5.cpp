// EXTI5: BMI088 gyroscope data ready, PC5. Line 23: RM0090 12.2, table 62.
#include "runtime/boards/robomaster_type_c/ports/exti_hardware.hpp"

namespace finemote {
namespace {

EdgeHardware hardware{{'C', 5}, 23};

}  // namespace

EdgePort ports::exti5{hardware};

extern "C" void finemote_line_23() { hardware.on_interrupt(); }

}  // namespace finemote
