// The longest time of an instruction by itself: with memory that never lets it wait.
#pragma once

#include <optional>

#include "generator/image/instruction.hpp"
#include "generator/wcet/memory_map.hpp"

namespace finemote::gen::wcet {

/// Cycles of an instruction that runs, without the refill where it goes elsewhere; none: there is no documented
/// maximum, or it has no place in code that must end in time (WFI, SVC). Source: Cortex-M4 TRM (DDI 0439D) tables 3-1
/// and 7-1 with the notes of 3.3: an address that the instruction before computed costs a cycle, a result of the FPU
/// that the next one takes another, a refill of the pipeline three.
std::optional<Cycles> longest_time(const Instruction& instruction);

/// The refill: besides, behind a branch that is taken, a call and a return.
inline constexpr Cycles kTaken = 3;
/// An instruction in an IT block whose condition fails.
inline constexpr Cycles kSkipped = 1;

}  // namespace finemote::gen::wcet
