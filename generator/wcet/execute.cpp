#include "generator/wcet/execute.hpp"

#include <algorithm>

#include "generator/wcet/carry.hpp"
#include "generator/wcet/forget.hpp"
#include "generator/wcet/memory_access.hpp"
#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

using Operation = Interval (*)(Interval, Interval);

std::uint32_t immediate(const Instruction& i, std::size_t at) { return i.has_immediate(at) ? i.immediate(at) : 0; }

/// `add r0, r1` is `add r0, r0, r1`.
std::size_t left_side(const Instruction& i) { return i.operands.size() > 2 ? 1 : 0; }

int register_at(const Instruction& i, std::size_t at) {
  const bool is_plain = at < i.operands.size() && i.operands[at].type == ARM_OP_REG &&
                        i.operands[at].shift.type == ARM_SFT_INVALID && Machine::follows(i.operands[at].reg);
  return is_plain ? i.operands[at].reg : static_cast<int>(ARM_REG_INVALID);
}

/// Flags of a result: zero or negative.
Comparison result_flags(int reg, Interval range) {
  Comparison flags;
  flags.left_range = range;
  flags.right_range = Interval::of(0);
  flags.result = reg;
  flags.only_result = true;
  return flags;
}

/// The value of an operation; of a place nothing but what it is made of.
void set_result(const Instruction& i, Value value, Machine& machine) {
  machine.set(i.operands[0].reg, value);
  const int reg = value.is_place ? static_cast<int>(ARM_REG_INVALID) : register_at(i, 0);
  if (i.sets_flags) machine.set_flags(result_flags(reg, value.anywhere()));
}

/// Wherever the stack is, it is aligned to eight bytes.
constexpr unsigned kKnownBits = 3;
constexpr std::uint32_t kKnownOfStack = (1U << kKnownBits) - 1U;

/// Of a place nothing but its lowest bits are looked at, or changed.
bool is_of_low_bits(Value place, Value other) {
  return place.is_place && place.range().is_constant() && !other.is_place && other.range().is_constant() &&
         other.range().low <= kKnownOfStack;
}

void compute(const Instruction& i, Operation operation, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  set_result(i, Value::in(operation(a.anywhere(), b.anywhere()), a.is_of_stack || b.is_of_stack), machine);
}

/// `and`, `bic`.
void mask(const Instruction& i, Operation operation, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  if (is_of_low_bits(a, b)) {
    const Interval range = operation(a.range(), b.range());
    return set_result(i, i.id == ARM_INS_BIC ? Value::place(range.low) : Value::in(range), machine);
  }
  set_result(i, Value::in(operation(a.anywhere(), b.anywhere()), a.is_of_stack || b.is_of_stack), machine);
}

bool are_distances(Value a, Value b) { return a.base == b.base && a.base != 0 && a.is_place == b.is_place; }

/// Both stay where they are, or both move with the stack.
bool are_alike(Value a, Value b) {
  if (a.is_place != b.is_place) return false;
  return !a.is_place || are_distances(a, b) || (a.is_on_stack() && b.is_on_stack());
}

/// Of distances from the same word only equality and the sign of the difference tell something: order may wrap.
Comparison compared(Value a, Value b) {
  Comparison flags;
  const bool is_of_distances = are_distances(a, b), is_alike = are_alike(a, b);
  const auto range = [&](Value v) { return is_of_distances ? v.distance : is_alike ? v.range() : v.anywhere(); };
  flags.left_range = range(a);
  flags.right_range = range(b);
  if (!is_of_distances) {
    const auto offset = [&](Value v) {
      const bool is_known = v.distance.is_constant() && (is_alike || !v.is_place);
      return is_known ? Comparison::Offset{v.base, v.distance.low} : Comparison::Offset{};
    };
    flags.left_offset = offset(a);
    flags.right_offset = offset(b);
  }
  flags.base = is_of_distances ? a.base : 0;
  flags.only_result = is_of_distances;
  return flags;
}

/// A register whose range the flags tell something of: not a place beside what does not move with it.
int narrowed(int reg, Value value, bool is_alike) {
  return is_alike || !value.is_place ? reg : static_cast<int>(ARM_REG_INVALID);
}

}  // namespace

Comparison comparison_of(Value a, Value b, int left, int right) {
  Comparison flags = compared(a, b);
  flags.left = narrowed(left, a, are_alike(a, b));
  flags.right = narrowed(right, b, are_alike(a, b));
  return flags;
}

namespace {

void compare(const Instruction& i, Machine& machine) {
  machine.set_flags(
      comparison_of(operand(i, 0, machine), operand(i, 1, machine), register_at(i, 0), register_at(i, 1)));
}

/// The flags of `subs` are those of a comparison of what its operands were.
void subtract_flags(const Instruction& i, Value a, Value b, Machine& machine) {
  const std::size_t left = left_side(i);
  const int target = register_at(i, 0);
  const auto kept = [target](int reg) { return reg == target ? static_cast<int>(ARM_REG_INVALID) : reg; };
  const bool is_subtraction = i.id == ARM_INS_SUB || i.id == ARM_INS_SUBW;
  Comparison flags = comparison_of(a, b, kept(register_at(i, left)),
                                   is_subtraction ? kept(register_at(i, left + 1)) : static_cast<int>(ARM_REG_INVALID));
  flags.result = narrowed(target, a, a.is_place == b.is_place);
  machine.set_flags(flags);
}

void subtraction(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  machine.set(i.operands[0].reg, difference(a, b));
  if (i.sets_flags) subtract_flags(i, a, b, machine);
}

void reverse_subtraction(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  set_result(i, difference(b, a), machine);
}

void move(const Instruction& i, Machine& machine) { set_result(i, operand(i, 1, machine), machine); }

void complement(const Instruction& i, Machine& machine) {
  const Value value = operand(i, 1, machine);
  set_result(i, Value::in(complement(value.anywhere()), value.is_of_stack), machine);
}

void move_top(const Instruction& i, Machine& machine) {
  const Value low = machine.get(i.operands[0].reg);
  const Interval bits = low.anywhere();
  const std::uint32_t high = immediate(i, 1) << 16U;
  machine.set(i.operands[0].reg,
              Value::in(bits.is_constant() ? Interval::of(high | (bits.low & 0xFFFFU)) : Interval{high, high | 0xFFFFU},
                        low.is_of_stack));
}

/// The flags of `adds` with a constant are those of a comparison with its negative: the carry says that it wrapped.
void addition(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  set_result(i, sum(a, b), machine);
  constexpr std::uint32_t kOwnNegative = 0x8000'0000;  // of which the overflow is the other way round
  const Interval added = b.anywhere();
  const bool is_comparison = i.sets_flags && added.is_constant() && added.low != 0 && added.low != kOwnNegative;
  if (is_comparison) subtract_flags(i, a, Value::of(0U - added.low), machine);
}

/// By an immediate, or by a register of which one value is known.
template <class Shift>
void shift(const Instruction& i, Shift by, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value value = operand(i, left, machine);
  const Interval count = operand(i, left + 1, machine).anywhere();
  const bool is_known = count.is_constant() && count.low < 32;
  const bool is_lowest = i.id == ARM_INS_LSL && is_known && count.low >= 32 - kKnownBits;
  const Interval range = is_lowest ? value.range() : value.anywhere();
  set_result(i, Value::in(is_known ? by(range, count.low) : Interval::any(), value.is_of_stack && !is_lowest), machine);
}

/// Of a register the lowest byte counts: ARMv7-M A2.2.1, `Shift_C()`.
constexpr std::uint32_t kLongestShift = 0xFF;

/// A right shift never makes a value larger.
void shift_right_logical(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const bool is_of_stack = operand(i, left, machine).is_of_stack;
  const Interval value = operand(i, left, machine).anywhere();
  Interval count = operand(i, left + 1, machine).anywhere();
  if (count.high > kLongestShift) count = {0, kLongestShift};
  const std::uint32_t least = std::min(count.low, 31U);
  const std::uint32_t low = count.is_constant() && count.low < 32 ? value.low >> count.low : 0;
  set_result(i, Value::in({low, value.high >> least}, is_of_stack), machine);
}

void extract(const Instruction& i, std::uint32_t from, std::uint32_t width, bool is_signed, Machine& machine) {
  const Value all = operand(i, 1, machine);
  const Interval value = shift_right(all.anywhere(), from);
  const std::uint32_t mask = width >= 32 ? UINT32_MAX : (1U << width) - 1U;
  Interval cut = value.high <= mask ? value : Interval{0, mask};
  if (is_signed && cut.high > mask / 2) cut = Interval::any();
  machine.set(i.operands[0].reg, Value::in(cut, all.is_of_stack));
}

void insert(const Instruction& i, Machine& machine) {
  const Value old = machine.get(i.operands[0].reg), field = operand(i, 1, machine);
  const Interval into = old.anywhere(), from = field.anywhere();
  const bool is_of_stack = old.is_of_stack || field.is_of_stack;
  const std::uint32_t at = immediate(i, 2), width = immediate(i, 3);
  if (!into.is_constant() || !from.is_constant() || width >= 32)
    return machine.set(i.operands[0].reg, Value::in(Interval::any(), is_of_stack));
  const std::uint32_t mask = ((1U << width) - 1U) << at;
  machine.set(i.operands[0].reg, Value::in(Interval::of((into.low & ~mask) | ((from.low << at) & mask)), is_of_stack));
}

/// An element of an array, from the address of its first.
void multiply_and(const Instruction& i, Value (*combine)(Value, Value), Machine& machine) {
  const Value a = operand(i, 1, machine), b = operand(i, 2, machine);
  const Value product = Value::in(multiply(a.anywhere(), b.anywhere()), a.is_of_stack || b.is_of_stack);
  machine.set(i.operands[0].reg, combine(operand(i, 3, machine), product));
}

void divide(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const Quotient quotient{register_at(i, 0), register_at(i, left), register_at(i, left + 1)};
  const bool is_by_zero = operand(i, left + 1, machine).anywhere().low == 0;
  compute(i, divide_unsigned, machine);
  const bool is_kept = quotient.result != quotient.dividend && quotient.result != quotient.divisor;
  if (is_kept && !is_by_zero) machine.set_quotient(quotient);
}

/// `a - quotient * divisor`: below the divisor.
std::optional<Value> remainder(const Instruction& i, const Machine& machine) {
  const auto& quotient = machine.quotient();
  const int a = register_at(i, 1), b = register_at(i, 2);
  if (!quotient || register_at(i, 3) != quotient->dividend) return std::nullopt;
  const bool is_product =
      (a == quotient->result && b == quotient->divisor) || (b == quotient->result && a == quotient->divisor);
  if (!is_product) return std::nullopt;
  const Value dividend = machine.get(quotient->dividend);
  const std::uint32_t most = machine.get(quotient->divisor).anywhere().high - 1;
  return Value::in({0, std::min(most, dividend.anywhere().high)}, dividend.is_of_stack);
}

void multiply_and_subtract(const Instruction& i, Machine& machine) {
  if (const auto rest = remainder(i, machine)) return machine.set(i.operands[0].reg, *rest);
  multiply_and(i, difference, machine);
}

Interval and_not(Interval a, Interval b) {
  if (a.is_constant() && b.is_constant()) return Interval::of(a.low & ~b.low);
  return {0, a.high};
}

/// `bic r0, r1, r1, asr #31`: the number, or 0 where it is negative.
bool is_cut_at_zero(const Instruction& i) {
  if (i.operands.size() != 3 || i.operands[2].type != ARM_OP_REG) return false;
  const cs_arm_op& sign = i.operands[2];
  return sign.reg == i.operands[1].reg && sign.shift.type == ARM_SFT_ASR && sign.shift.value == 31;
}

void cut_at_zero(const Instruction& i, Machine& machine) {
  const Value number = machine.get(i.operands[1].reg);
  const Interval range = number.anywhere();
  const bool is_positive = range.high <= INT32_MAX;
  set_result(i, Value::in(is_positive ? range : Interval{0, INT32_MAX}, number.is_of_stack), machine);
}

/// False: not modelled.
bool arithmetic(const Instruction& i, Machine& machine) {
  switch (i.id) {
    case ARM_INS_ADD:
    case ARM_INS_ADDW:
      return addition(i, machine), true;
    case ARM_INS_SUB:
    case ARM_INS_SUBW:
      return subtraction(i, machine), true;
    case ARM_INS_RSB:
      return reverse_subtraction(i, machine), true;
    case ARM_INS_AND:
      return mask(i, bitwise_and, machine), true;
    case ARM_INS_ORR:
      return compute(i, bitwise_or, machine), true;
    case ARM_INS_EOR:
      return compute(i, exclusive_or, machine), true;
    case ARM_INS_BIC:
      return is_cut_at_zero(i) ? cut_at_zero(i, machine) : mask(i, and_not, machine), true;
    case ARM_INS_MUL:
      return compute(i, multiply, machine), true;
    case ARM_INS_UDIV:
      return divide(i, machine), true;
    case ARM_INS_MLA:
      return multiply_and(i, sum, machine), true;
    case ARM_INS_MLS:
      return multiply_and_subtract(i, machine), true;
    case ARM_INS_LSL:
      return shift(i, shift_left, machine), true;
    case ARM_INS_LSR:
      return shift_right_logical(i, machine), true;
    case ARM_INS_ASR:
      return shift(i, shift_right_signed, machine), true;
    default:
      return false;
  }
}

bool moves_and_fields(const Instruction& i, Machine& machine) {
  switch (i.id) {
    case ARM_INS_MOV:
    case ARM_INS_MOVW:
      return move(i, machine), true;
    case ARM_INS_MOVT:
      return move_top(i, machine), true;
    case ARM_INS_MVN:
      return complement(i, machine), true;
    case ARM_INS_ADR:
      return machine.set(i.operands[0].reg, Value::of(((i.address + 4) & ~3U) + immediate(i, 1))), true;
    case ARM_INS_UXTB:
      return extract(i, 0, 8, false, machine), true;
    case ARM_INS_UXTH:
      return extract(i, 0, 16, false, machine), true;
    case ARM_INS_SXTB:
      return extract(i, 0, 8, true, machine), true;
    case ARM_INS_SXTH:
      return extract(i, 0, 16, true, machine), true;
    case ARM_INS_UBFX:
      return extract(i, immediate(i, 2), immediate(i, 3), false, machine), true;
    case ARM_INS_SBFX:
      return extract(i, immediate(i, 2), immediate(i, 3), true, machine), true;
    case ARM_INS_BFI:
      return insert(i, machine), true;
    case ARM_INS_CLZ:
      return machine.set(i.operands[0].reg, Value::in({0, 32})), true;
    default:
      return false;
  }
}

bool flag_setting(const Instruction& i, Machine& machine) {
  const Value left = operand(i, 0, machine), right = operand(i, 1, machine);
  const bool is_low = is_of_low_bits(left, right);
  const Interval a = is_low ? left.range() : left.anywhere(), b = right.anywhere();
  switch (i.id) {
    case ARM_INS_CMP:
      return compare(i, machine), true;
    case ARM_INS_CMN:
      return machine.set_flags(result_flags(ARM_REG_INVALID, add(a, b))), true;
    case ARM_INS_TST:
      return machine.set_flags(result_flags(ARM_REG_INVALID, bitwise_and(a, b))), true;
    case ARM_INS_TEQ:
      return machine.set_flags(result_flags(ARM_REG_INVALID, exclusive_or(a, b))), true;
    default:
      return false;
  }
}

bool leaves_machine(unsigned id) {
  switch (id) {
    case ARM_INS_B:
    case ARM_INS_BX:
    case ARM_INS_CBZ:
    case ARM_INS_CBNZ:
    case ARM_INS_TBB:
    case ARM_INS_TBH:
    case ARM_INS_IT:
    case ARM_INS_NOP:
    case ARM_INS_DSB:
    case ARM_INS_DMB:
    case ARM_INS_ISB:
    case ARM_INS_CPS:
      return true;
    default:
      return false;
  }
}

void run(const Instruction& i, const Surroundings& surroundings, Machine& machine) {
  if (i.id == ARM_INS_BL || i.id == ARM_INS_BLX) {
    machine.set(ARM_REG_LR, Value::of(i.end() | 1U));
    return machine.keep_link();
  }
  const MemoryUse use = memory_use(i, machine);
  if (use.kind != MemoryUse::Kind::none) return access_memory(i, use, surroundings, machine);
  if (flag_setting(i, machine) || arithmetic(i, machine) || moves_and_fields(i, machine) || use_carry(i, machine))
    return;
  forget(i, machine);
}

}  // namespace

void execute(const Instruction& i, const Surroundings& surroundings, Machine& machine) {
  if (leaves_machine(i.id)) return;
  run(i, surroundings, machine);
  machine.name_unknowns(surroundings.unknowns);
}

}  // namespace finemote::gen::wcet
