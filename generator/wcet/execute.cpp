#include "generator/wcet/execute.hpp"

#include <algorithm>

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

void set_result(const Instruction& i, Value value, Machine& machine) {
  machine.set(i.operands[0].reg, value);
  if (i.sets_flags) machine.set_flags(result_flags(register_at(i, 0), value.range()));
}

/// The stack is aligned to eight bytes where a routine begins (AAPCS 6.2.1.2, ARMv7-M B1.5.7 with STKALIGN).
constexpr unsigned kKnownBits = 3;
constexpr std::uint32_t kKnownOfStack = (1U << kKnownBits) - 1U;
/// No part of it lies below the core-coupled RAM.
constexpr std::uint32_t kLeastOfStack = 0x1000'0000;

/// What an operation sees that is none of addresses: where the stack lies is only known up to what has been preempted.
Interval seen(Value value) {
  const Interval range = value.range();
  return value.is_of_stack && range.high >= kLeastOfStack ? Interval::any() : range;
}

/// The same where nothing but the lowest bits of the other operand are looked at, or changed.
Interval seen_beside(Value value, Interval other) {
  const bool is_of_low_bits = other.is_constant() && other.low <= kKnownOfStack;
  return is_of_low_bits ? value.range() : seen(value);
}

/// The result of such an operation.
Value made_of(bool is_of_stack, Interval range) { return Value::in(range, is_of_stack && range.high >= kLeastOfStack); }

/// @param may_keep_stack  the result of an address in the stack may be one
void compute(const Instruction& i, Operation operation, bool may_keep_stack, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  const bool is_of_stack = may_keep_stack && (a.is_of_stack || b.is_of_stack);
  set_result(i, made_of(is_of_stack, operation(seen(a), seen(b))), machine);
}

/// `and`, `bic`.
void mask(const Instruction& i, Operation operation, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  const bool is_of_stack = a.is_of_stack || b.is_of_stack;
  set_result(i, made_of(is_of_stack, operation(seen_beside(a, seen(b)), seen_beside(b, seen(a)))), machine);
}

/// Of distances from the same word only equality and the sign of the difference tell something: order may wrap.
Comparison compared(Value a, Value b) {
  Comparison flags;
  const bool is_of_distances = a.base == b.base && a.base != 0;
  flags.left_range = is_of_distances ? a.distance : a.range();
  flags.right_range = is_of_distances ? b.distance : b.range();
  if (!is_of_distances) {
    const auto offset = [](Value v) {
      return v.distance.is_constant() ? Comparison::Offset{v.base, v.distance.low} : Comparison::Offset{};
    };
    flags.left_offset = offset(a);
    flags.right_offset = offset(b);
  }
  flags.base = is_of_distances ? a.base : 0;
  flags.only_result = is_of_distances;
  return flags;
}

void compare(const Instruction& i, Machine& machine) {
  machine.set_flags(
      comparison_of(operand(i, 0, machine), operand(i, 1, machine), register_at(i, 0), register_at(i, 1)));
}

/// The flags of `subs` are those of a comparison of what its operands were.
void subtract_flags(const Instruction& i, Value a, Value b, Machine& machine) {
  const std::size_t left = left_side(i);
  const int target = register_at(i, 0);
  const auto kept = [target](int reg) { return reg == target ? static_cast<int>(ARM_REG_INVALID) : reg; };
  Comparison flags = compared(a, b);
  flags.left = kept(register_at(i, left));
  flags.right =
      i.id == ARM_INS_SUB || i.id == ARM_INS_SUBW ? kept(register_at(i, left + 1)) : static_cast<int>(ARM_REG_INVALID);
  flags.result = target;
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

void move(const Instruction& i, Machine& machine) {
  const Value value = operand(i, 1, machine);
  set_result(i, value, machine);
}

void move_top(const Instruction& i, Machine& machine) {
  const Interval low = seen(machine.get(i.operands[0].reg));
  const std::uint32_t high = immediate(i, 1) << 16U;
  const bool is_known = low.is_constant();
  machine.set(i.operands[0].reg,
              Value::in(is_known ? Interval::of(high | (low.low & 0xFFFFU)) : Interval{high, high | 0xFFFFU}));
}

/// The flags of `adds` with a constant are those of a comparison with its negative: the carry says that it wrapped.
void addition(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value a = operand(i, left, machine), b = operand(i, left + 1, machine);
  set_result(i, sum(a, b), machine);
  const bool is_comparison = i.sets_flags && b.range().is_constant() && b.range().low != 0;
  if (is_comparison) subtract_flags(i, a, Value::of(0U - b.range().low), machine);
}

/// By an immediate, or by a register of which one value is known.
template <class Shift>
void shift(const Instruction& i, Shift by, Machine& machine) {
  const std::size_t left = left_side(i);
  const Value value = operand(i, left, machine);
  const Interval count = seen(operand(i, left + 1, machine));
  const bool is_known = count.is_constant() && count.low < 32;
  const bool is_of_low_bits = i.id == ARM_INS_LSL && is_known && count.low >= 32 - kKnownBits;
  const Interval range = is_of_low_bits ? value.range() : seen(value);
  set_result(i, made_of(value.is_of_stack, is_known ? by(range, count.low) : Interval::any()), machine);
}

/// A right shift never makes a value larger.
void shift_right_logical(const Instruction& i, Machine& machine) {
  const std::size_t left = left_side(i);
  const bool is_of_stack = operand(i, left, machine).is_of_stack;
  const Interval value = seen(operand(i, left, machine)), count = seen(operand(i, left + 1, machine));
  const std::uint32_t least = std::min(count.low, 31U);
  const std::uint32_t low = count.is_constant() && count.low < 32 ? value.low >> count.low : 0;
  set_result(i, made_of(is_of_stack, {low, value.high >> least}), machine);
}

void extract(const Instruction& i, std::uint32_t from, std::uint32_t width, bool is_signed, Machine& machine) {
  const Value all = operand(i, 1, machine);
  const Interval value = shift_right(from + width <= kKnownBits ? all.range() : seen(all), from);
  const std::uint32_t mask = width >= 32 ? UINT32_MAX : (1U << width) - 1U;
  Interval cut = value.high <= mask ? value : Interval{0, mask};
  if (is_signed && cut.high > mask / 2) cut = Interval::any();
  machine.set(i.operands[0].reg, Value::in(cut));
}

void insert(const Instruction& i, Machine& machine) {
  const Value old = machine.get(i.operands[0].reg), field = operand(i, 1, machine);
  const Interval into = seen(old), from = seen(field);
  const std::uint32_t at = immediate(i, 2), width = immediate(i, 3);
  if (!into.is_constant() || !from.is_constant() || width >= 32)
    return machine.set(i.operands[0].reg, Value::in(Interval::any(), old.is_of_stack || field.is_of_stack));
  const std::uint32_t mask = ((1U << width) - 1U) << at;
  machine.set(i.operands[0].reg, Value::of((into.low & ~mask) | ((from.low << at) & mask)));
}

/// An element of an array, from the address of its first.
void multiply_and(const Instruction& i, Value (*combine)(Value, Value), Machine& machine) {
  const Interval product = multiply(seen(operand(i, 1, machine)), seen(operand(i, 2, machine)));
  machine.set(i.operands[0].reg, combine(operand(i, 3, machine), Value::in(product)));
}

Interval and_not(Interval a, Interval b) {
  if (a.is_constant() && b.is_constant()) return Interval::of(a.low & ~b.low);
  return {0, a.high};
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
      return compute(i, bitwise_or, true, machine), true;
    case ARM_INS_EOR:
      return compute(i, exclusive_or, true, machine), true;
    case ARM_INS_BIC:
      return mask(i, and_not, machine), true;
    case ARM_INS_MUL:
      return compute(i, multiply, false, machine), true;
    case ARM_INS_UDIV:
      return compute(i, divide_unsigned, false, machine), true;
    case ARM_INS_MLA:
      return multiply_and(i, sum, machine), true;
    case ARM_INS_MLS:
      return multiply_and(i, difference, machine), true;
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
      return set_result(i, made_of(operand(i, 1, machine).is_of_stack, complement(seen(operand(i, 1, machine)))),
                        machine),
             true;
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
  const Interval a = seen(left), b = seen(right);
  switch (i.id) {
    case ARM_INS_CMP:
      return compare(i, machine), true;
    case ARM_INS_CMN:
      return machine.set_flags(result_flags(ARM_REG_INVALID, add(a, b))), true;
    case ARM_INS_TST:
      return machine.set_flags(result_flags(ARM_REG_INVALID, bitwise_and(seen_beside(left, b), seen_beside(right, a)))),
             true;
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

Value loaded(const Access& access, bool is_signed, const Surroundings& surroundings, const Machine& machine) {
  const std::uint32_t highest = access.size == 4 ? UINT32_MAX : (1U << (8 * access.size)) - 1U;
  Value value = Value::in({0, highest}, access.size == 4 && machine.has_escaped());
  if (access.address.is_of_stack)
    value = machine.stack().load(access);
  else if (const auto constant = surroundings.constants.load(access))
    value = Value::in(*constant);
  return is_signed && value.range().high > highest / 2 ? Value::in(Interval::any()) : value;
}

void note(const Access& access, Value value, WordStores& stores) {
  if (access.size != 4 || !access.address.range().is_constant()) return;
  const auto [known, is_new] = stores.try_emplace(access.address.range().low, value.range());
  if (!is_new) known->second = join(known->second, value.range());
}

void store(const Transferred& word, const Surroundings& surroundings, Machine& machine) {
  const Value value = Machine::follows(word.reg) ? machine.get(word.reg) : Value::in(Interval::any(), true);
  if (word.access.address.is_of_stack)
    machine.stack().store(word.access, value);
  else if (value.is_of_stack && word.access.size == 4 && Machine::follows(word.reg))
    machine.escape();
  if (surroundings.stores != nullptr && !word.access.address.is_of_stack)
    note(word.access, value, *surroundings.stores);
}

void access_memory(const Instruction& i, const MemoryUse& use, const Surroundings& surroundings, Machine& machine) {
  const bool is_signed = use.kind == MemoryUse::Kind::load_signed;
  std::vector<std::pair<int, Value>> loads;
  for (const Transferred& word : use.words) {
    if (use.kind == MemoryUse::Kind::store)
      store(word, surroundings, machine);
    else if (Machine::follows(word.reg))
      loads.emplace_back(word.reg, loaded(word.access, is_signed, surroundings, machine));
  }
  if (use.base) machine.set(use.base->first, use.base->second);
  for (const auto& [reg, value] : loads) machine.set(reg, value);
  // It succeeds where no exception comes between it and the load before (ARMv7-M A3.4.1): a repetition is part of what
  // a preemption costs.
  if (is_exclusive_store(i.id)) machine.set(i.operands[0].reg, Value::of(0));
}

/// Whatever it may write is unknown, and of the stack where something it reads is. Registers of the FPU hold no
/// address.
void forget(const Instruction& i, Machine& machine) {
  const bool is_of_stack = std::any_of(i.operands.begin(), i.operands.end(), [&](const cs_arm_op& op) {
    return op.type == ARM_OP_REG && Machine::follows(op.reg) && machine.get(op.reg).is_of_stack;
  });
  for (const cs_arm_op& op : i.operands) {
    if (op.type == ARM_OP_REG && may_write(i, op.reg)) machine.set(op.reg, Value::in(Interval::any(), is_of_stack));
  }
  if (i.sets_flags || i.id == ARM_INS_VMRS || i.id == ARM_INS_MSR) machine.set_flags(std::nullopt);
}

}  // namespace

Comparison comparison_of(Value a, Value b, int left, int right) {
  Comparison flags = compared(a, b);
  flags.left = left;
  flags.right = right;
  return flags;
}

namespace {

void run(const Instruction& i, const Surroundings& surroundings, Machine& machine) {
  if (i.id == ARM_INS_BL || i.id == ARM_INS_BLX) return machine.set(ARM_REG_LR, Value::of(i.end() | 1U));
  const MemoryUse use = memory_use(i, machine);
  if (use.kind != MemoryUse::Kind::none) return access_memory(i, use, surroundings, machine);
  if (flag_setting(i, machine) || arithmetic(i, machine) || moves_and_fields(i, machine)) return;
  forget(i, machine);
}

}  // namespace

void execute(const Instruction& i, const Surroundings& surroundings, Machine& machine) {
  if (leaves_machine(i.id)) return;
  run(i, surroundings, machine);
  machine.name_unknowns(surroundings.unknowns);
}

}  // namespace finemote::gen::wcet
