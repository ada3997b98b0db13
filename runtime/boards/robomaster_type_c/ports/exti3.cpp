// EXTI3: IST8310 data ready, PG3. Line 9: RM0090 12.2, table 62.
#include "runtime/boards/robomaster_type_c/ports/exti_hardware.hpp"

namespace finemote {
namespace {

EdgeHardware hardware{{'G', 3}, 9};

}  // namespace

EdgePort ports::exti3{hardware};

extern "C" void finemote_line_9() { hardware.on_interrupt(); }

}  // namespace finemote
