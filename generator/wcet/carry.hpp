// Sums and differences of more than a word, where the carry from the lower word is known.
#pragma once

#include "generator/image/instruction.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// `adc`, `sbc`. False: it is neither, the carry is not known, or an operand is made of an address in the stack.
bool use_carry(const Instruction& instruction, Machine& machine);

}  // namespace finemote::gen::wcet
