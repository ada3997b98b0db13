// Code that keeps interrupts out, or takes another stack.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/image/program.hpp"
#include "generator/wcet/marks.hpp"

namespace finemote::gen::wcet {

/// An instruction of the block that keeps interrupts out, other than those at the start and the end of a section that
/// is marked as masked: how long such sections are is known. None: there is no such instruction.
std::optional<std::uint32_t> masks_by_itself(const ProgramFunction& function, const BasicBlock& block,
                                             const Marks& marks);

/// An instruction of the block that sets a stack pointer by MSR. None: there is no such instruction.
std::optional<std::uint32_t> sets_stack_pointer(const ProgramFunction& function, const BasicBlock& block);

}  // namespace finemote::gen::wcet
