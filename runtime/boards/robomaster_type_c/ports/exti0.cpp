// EXTI0: user key, PA0. Line 6: RM0090 12.2, table 62.
#include "runtime/boards/robomaster_type_c/ports/exti_hardware.hpp"

namespace finemote {
namespace {

EdgeHardware hardware{{'A', 0}, 6};

}  // namespace

EdgePort ports::exti0{hardware};

extern "C" void finemote_line_6() { hardware.on_interrupt(); }

}  // namespace finemote
