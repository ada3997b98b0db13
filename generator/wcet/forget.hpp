// What is still known of a machine after an instruction of which only the registers are known.
#pragma once

#include "generator/image/instruction.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// Whatever it may write is unknown, and of the stack where something it reads is.
void forget(const Instruction& instruction, Machine& machine);

}  // namespace finemote::gen::wcet
