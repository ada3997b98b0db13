#include "generator/wcet/carry.hpp"

#include <optional>

#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

bool is_possible(Machine machine, arm_cc condition) { return machine.assume(condition); }

/// HS and LO ask for the carry alone: ARMv7-M A7.3.
std::optional<std::uint32_t> carry_of(const Machine& machine) {
  const bool may_be_set = is_possible(machine, ARM_CC_HS), may_be_clear = is_possible(machine, ARM_CC_LO);
  if (may_be_set == may_be_clear) return std::nullopt;
  return may_be_set ? 1 : 0;
}

}  // namespace

/// ARMv7-M A7.7, ADC and SBC: `a + b + carry`, and `a - b - 1 + carry`.
bool use_carry(const Instruction& i, Machine& machine) {
  if (i.id != ARM_INS_ADC && i.id != ARM_INS_SBC) return false;
  const std::size_t left = i.operands.size() > 2 ? 1 : 0;
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  const auto carry = carry_of(machine);
  if (!carry || a.is_of_stack || b.is_of_stack) return false;
  const Value result =
      i.id == ARM_INS_ADC ? sum(sum(a, b), Value::of(*carry)) : difference(difference(a, b), Value::of(1 - *carry));
  machine.set(i.operands[0].reg, result);
  if (i.sets_flags) machine.set_flags(std::nullopt);
  return true;
}

}  // namespace finemote::gen::wcet
