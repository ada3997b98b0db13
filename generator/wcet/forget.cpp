#include "generator/wcet/forget.hpp"

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

/// How many registers it only writes: those of a result that is not made of them.
std::size_t written_only(const Instruction& i) {
  switch (i.id) {
    case ARM_INS_ADC:
    case ARM_INS_SBC:
    case ARM_INS_ORN:
    case ARM_INS_ROR:
    case ARM_INS_SDIV:
      return i.operands.size() > 2 ? 1 : 0;
    case ARM_INS_RBIT:
    case ARM_INS_REV:
    case ARM_INS_REV16:
    case ARM_INS_REVSH:
    case ARM_INS_MRS:
    case ARM_INS_VMOV:
      return 1;
    case ARM_INS_UMULL:
    case ARM_INS_SMULL:
      return 2;
    default:
      return 0;
  }
}

bool is_of_stack(const cs_arm_op& op, const Machine& machine) {
  if (op.type != ARM_OP_REG) return false;
  return Machine::follows(op.reg) ? machine.get(op.reg).is_of_stack : machine.is_stack_in_fpu() && is_of_fpu(op.reg);
}

/// `mrs r0, msp`.
bool reads_stack_pointer(const Instruction& i) {
  return i.id == ARM_INS_MRS && (i.text.find("msp") != std::string::npos || i.text.find("psp") != std::string::npos);
}

}  // namespace

void forget(const Instruction& i, Machine& machine) {
  const auto read = i.operands.begin() + static_cast<std::ptrdiff_t>(std::min(written_only(i), i.operands.size()));
  const bool is_made_of_stack = reads_stack_pointer(i) || std::any_of(read, i.operands.end(), [&](const cs_arm_op& op) {
                                  return is_of_stack(op, machine);
                                });
  if (i.id == ARM_INS_CLREX) machine.set_exclusive(true);
  for (const cs_arm_op& op : i.operands) {
    if (op.type != ARM_OP_REG) continue;
    if (may_write(i, op.reg)) machine.set(op.reg, Value::in(Interval::any(), is_made_of_stack));
    if (is_made_of_stack && is_of_fpu(op.reg)) machine.put_stack_in_fpu();
  }
  if (i.sets_flags || i.id == ARM_INS_VMRS || i.id == ARM_INS_MSR) machine.set_flags(std::nullopt);
}

}  // namespace finemote::gen::wcet
