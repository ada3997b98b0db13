// One Thumb-2 instruction of an image, decoded.
#pragma once

#include <capstone/capstone.h>

#include <cstdint>
#include <string>
#include <vector>

namespace finemote::gen {

struct Instruction {
  std::uint32_t address = 0;
  std::uint32_t size = 2;         ///< bytes, 2 or 4
  unsigned id = ARM_INS_INVALID;  ///< ARM_INS_*; ARM_INS_INVALID: no instruction that the decoder knows
  arm_cc condition = ARM_CC_AL;   ///< of a branch, or of the IT block it is in
  bool sets_flags = false;
  bool writes_back = false;  ///< the base register of its memory operand changes
  std::vector<cs_arm_op> operands;
  std::string text;  ///< as in assembler, for messages

  [[nodiscard]] std::uint32_t end() const { return address + size; }
  [[nodiscard]] bool is_known() const { return id != ARM_INS_INVALID; }
  [[nodiscard]] bool is_conditional() const { return condition != ARM_CC_AL && condition != ARM_CC_INVALID; }
  /// Operand `i` is this register.
  [[nodiscard]] bool has_register(std::size_t i, int reg) const {
    return i < operands.size() && operands[i].type == ARM_OP_REG && operands[i].reg == reg;
  }
  [[nodiscard]] bool has_immediate(std::size_t i) const {
    return i < operands.size() && operands[i].type == ARM_OP_IMM;
  }
  /// Unsigned value of operand `i`, which is an immediate.
  [[nodiscard]] std::uint32_t immediate(std::size_t i) const { return static_cast<std::uint32_t>(operands[i].imm); }
  /// The memory operand, or null.
  [[nodiscard]] const cs_arm_op* memory() const;
  /// Number of the registers listed from operand `first` on, in words: a double register is two.
  [[nodiscard]] std::uint32_t words_from(std::size_t first) const;
};

/// A single or double register of the FPU.
bool is_of_fpu(int reg);

/// Whether it may change this core register: what the architecture says it writes, and for a call what a callee may
/// change (AAPCS 6.1.1: r0 to r3, r12 and lr).
bool may_write(const Instruction& instruction, int reg);

/// All instructions from `begin` on in `code`, which holds no data. What the decoder does not know has no id and the
/// size its first halfword says (ARMv7-M A5.1); a cut last instruction has a size that reaches beyond the code.
std::vector<Instruction> decode(std::uint32_t begin, std::string_view code);

}  // namespace finemote::gen
