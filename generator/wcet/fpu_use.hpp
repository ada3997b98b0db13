// Whether a routine touches the floating-point unit.
#pragma once

#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// True where an instruction of the unit is on any way: the registers of what it interrupts are then saved at the first
/// such instruction, and restored when it returns (Cortex-M4 TRM 3.9.1, lazy stacking).
bool uses_fpu(const UnrolledGraph& graph);

}  // namespace finemote::gen::wcet
