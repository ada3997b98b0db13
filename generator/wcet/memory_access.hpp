// What loads and stores do on a machine.
#pragma once

#include "generator/wcet/execute.hpp"
#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {

/// Carries out an instruction that reads or writes memory.
void access_memory(const Instruction& instruction, const MemoryUse& use, const Surroundings& surroundings,
                   Machine& machine);

}  // namespace finemote::gen::wcet
