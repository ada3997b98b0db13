// What the operands of an instruction stand for on a machine.
#pragma once

#include <optional>
#include <vector>

#include "generator/image/instruction.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {

/// Operand `i`, a register or an immediate, shifted where it says so.
Value operand(const Instruction& instruction, std::size_t i, const Machine& machine);

/// One word, halfword or byte that an instruction loads or stores, and the register it comes from or goes to.
struct Transferred {
  Access access;
  int reg = ARM_REG_INVALID;
};

/// How an instruction touches memory, in the order of addresses.
struct MemoryUse {
  enum class Kind { none, load, load_signed, store } kind = Kind::none;
  std::vector<Transferred> words;
  /// The base register afterwards, where it changes.
  std::optional<std::pair<int, Value>> base;
};

/// STREX, STREXB, STREXH: the first operand becomes whether it failed.
bool is_exclusive_store(unsigned id);
/// LDREX, LDREXB, LDREXH.
bool is_exclusive_load(unsigned id);

/// Of loads and stores of core and FPU registers; a register of the FPU with 8 bytes is two words.
MemoryUse memory_use(const Instruction& instruction, const Machine& machine);

}  // namespace finemote::gen::wcet
