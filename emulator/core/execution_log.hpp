// Keeps when exceptions came and went, when interrupts were masked, and when marked places of the image were passed.
#pragma once

#include <cstdint>
#include <vector>

#include "emulator/time.hpp"

namespace finemote::emulator {

struct ExecutionEvent {
  enum class Kind : std::uint8_t {
    enter,   ///< stacking begins; `number`: the exception
    tail,    ///< the same, directly after another routine: nothing is stacked
    leave,   ///< the last instruction of the routine has ended; `number`: the exception
    resume,  ///< unstacking has ended; `number`: the exception that was left
    mask,    ///< PRIMASK, FAULTMASK or BASEPRI keeps interrupts out from now on
    unmask,  ///< none of them does
    due,     ///< `number`: the exception, pending from now on
    mark,    ///< the instruction at a mark begins; `number`: what the mark stands for
    loop,    ///< the instruction at a watched place of a loop begins; `number`: which
    save,  ///< registers of the floating-point unit were saved late, for what was preempted; `number`: the time it took
    reset,  ///< the processor starts anew
  };

  Time at = 0;
  std::uint32_t number = 0;
  Kind kind = Kind::enter;
};

using ExecutionLog = std::vector<ExecutionEvent>;

}  // namespace finemote::emulator
