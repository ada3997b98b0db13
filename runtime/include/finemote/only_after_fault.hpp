// Places that are reached only once something has gone wrong: docs/wcet.md.
#pragma once

#include "finemote/assembler.hpp"

namespace finemote {

/// This place is reached only after a fault: a frame that was damaged, lost or refused, a bus that recovers, a
/// processor or a schedule in trouble; or before the bring-up is over, from when on times count. It costs no
/// instruction; tools leave the ways through it out of the times without faults.
[[gnu::always_inline]] inline void only_after_fault() {
  FINEMOTE_ASM("0:" FINEMOTE_FOR_TOOLS(".debug_finemote_faults", ".word 0b, 0")::);
}

}  // namespace finemote
