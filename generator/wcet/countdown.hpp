// Loops that do nothing but count a register down to zero: `subs r, #1; bne`.
#pragma once

#include <optional>

#include "generator/image/program.hpp"

namespace finemote::gen::wcet {

/// The register that `block` counts down by one until it is zero, ARM_REG_*; none: it does something else. Such a loop
/// need not be followed iteration by iteration: all are alike, as many as the register says.
std::optional<int> counted_down(const ProgramFunction& function, const BasicBlock& block);

}  // namespace finemote::gen::wcet
