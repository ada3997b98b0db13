#include "generator/image/transfer.hpp"

#include <cstddef>

namespace finemote::gen {
namespace {

using Kind = Transfer::Kind;

bool lists_pc(const Instruction& i, std::size_t first) {
  for (std::size_t o = first; o < i.operands.size(); ++o) {
    if (i.has_register(o, ARM_REG_PC)) return true;
  }
  return false;
}

/// `ldr pc, [sp], #4`: what `pop {pc}` is with 32 bits.
bool loads_return_address(const Instruction& i) {
  return i.id == ARM_INS_LDR && i.memory() != nullptr && i.memory()->mem.base == ARM_REG_SP && i.writes_back;
}

/// `ldr pc, [r2, r3, lsl #2]`.
bool is_word_table(const Instruction& i) {
  const cs_arm_op* memory = i.memory();
  return i.id == ARM_INS_LDR && memory != nullptr && memory->mem.index != ARM_REG_INVALID && memory->shift.value == 2;
}

/// Anything else whose first operand is the program counter.
Kind kind_of_write_to_pc(const Instruction& i) {
  if (loads_return_address(i)) return Kind::leave;
  if (is_word_table(i)) return Kind::table;
  return i.id == ARM_INS_MOV && i.has_register(1, ARM_REG_LR) ? Kind::leave : Kind::unknown;
}

Kind kind_of(const Instruction& i) {
  switch (i.id) {
    case ARM_INS_INVALID:
      return Kind::unknown;
    case ARM_INS_B:
    case ARM_INS_CBZ:
    case ARM_INS_CBNZ:
      return Kind::jump;
    case ARM_INS_BL:
      return Kind::call;
    case ARM_INS_BLX:
      return i.has_immediate(0) ? Kind::call : Kind::indirect;
    case ARM_INS_BX:
      return i.has_register(0, ARM_REG_LR) ? Kind::leave : Kind::tail;
    case ARM_INS_TBB:
    case ARM_INS_TBH:
      return Kind::table;
    case ARM_INS_UDF:
    case ARM_INS_BKPT:
      return Kind::stop;
    case ARM_INS_POP:
      return lists_pc(i, 0) ? Kind::leave : Kind::next;
    case ARM_INS_LDM:
    case ARM_INS_LDMDB:
      return lists_pc(i, 1) ? Kind::leave : Kind::next;
    case ARM_INS_MOV:
    case ARM_INS_LDR:
    case ARM_INS_ADD:
      return i.has_register(0, ARM_REG_PC) ? kind_of_write_to_pc(i) : Kind::next;
    default:
      return Kind::next;
  }
}

bool is_branch_on_register(const Instruction& i) { return i.id == ARM_INS_CBZ || i.id == ARM_INS_CBNZ; }

}  // namespace

Transfer transfer_of(const Instruction& instruction) {
  Transfer transfer{kind_of(instruction), true, 0};
  const bool is_call = transfer.kind == Kind::call || transfer.kind == Kind::indirect;
  transfer.may_fall_through =
      transfer.kind == Kind::next || is_call || instruction.is_conditional() || is_branch_on_register(instruction);
  if (transfer.kind == Kind::jump || transfer.kind == Kind::call)
    transfer.target = instruction.immediate(is_branch_on_register(instruction) ? 1 : 0) & ~1U;
  return transfer;
}

}  // namespace finemote::gen
