#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

using Kind = MemoryUse::Kind;

Interval shifted(Interval range, const cs_arm_op& op) {
  switch (op.shift.type) {
    case ARM_SFT_LSL:
      return shift_left(range, op.shift.value & 31U);
    case ARM_SFT_LSR:
      return op.shift.value >= 32 ? Interval::of(0) : shift_right(range, op.shift.value);
    case ARM_SFT_ASR:
      return shift_right_signed(range, op.shift.value >= 32 ? 31U : op.shift.value);
    default:
      return Interval::any();
  }
}

/// The program counter reads as the address of the instruction and 4; as a base it is aligned (ARMv7-M A5.1.2).
Value base_of(const Instruction& i, int reg, const Machine& machine) {
  return reg == ARM_REG_PC ? Value::of((i.address + 4) & ~3U) : machine.get(reg);
}

Value shifted(Value value, const cs_arm_op& op) {
  return op.shift.type == ARM_SFT_INVALID ? value : Value::in(shifted(value.anywhere(), op), value.is_of_stack);
}

struct Form {
  Kind kind = Kind::none;
  std::uint32_t size = 4;
};

Form form_of(unsigned id) {
  switch (id) {
    case ARM_INS_LDR:
    case ARM_INS_LDREX:
    case ARM_INS_LDRD:
    case ARM_INS_VLDR:
      return {Kind::load, 4};
    case ARM_INS_LDRB:
    case ARM_INS_LDREXB:
      return {Kind::load, 1};
    case ARM_INS_LDRH:
    case ARM_INS_LDREXH:
      return {Kind::load, 2};
    case ARM_INS_LDRSB:
      return {Kind::load_signed, 1};
    case ARM_INS_LDRSH:
      return {Kind::load_signed, 2};
    case ARM_INS_STR:
    case ARM_INS_STRD:
    case ARM_INS_VSTR:
    case ARM_INS_STREX:
      return {Kind::store, 4};
    case ARM_INS_STRB:
    case ARM_INS_STREXB:
      return {Kind::store, 1};
    case ARM_INS_STRH:
    case ARM_INS_STREXH:
      return {Kind::store, 2};
    default:
      return {};
  }
}

bool is_double(int reg) { return reg >= ARM_REG_D0 && reg <= ARM_REG_D31; }

void append(MemoryUse& use, Value address, std::uint32_t size, int reg, std::uint32_t step = 1) {
  const std::uint32_t words = is_double(reg) ? 2 : 1;
  for (std::uint32_t word = 0; word < words; ++word) {
    const Value at = sum(address, Value::of(4 * static_cast<std::uint32_t>(use.words.size())));
    use.words.push_back({{at, size, step}, reg});
  }
}

Value effective_address(const Instruction& i, const cs_arm_op& memory, const Machine& machine) {
  Value address = sum(base_of(i, memory.mem.base, machine), Value::of(static_cast<std::uint32_t>(memory.mem.disp)));
  if (memory.mem.index == ARM_REG_INVALID) return address;
  const Value index = shifted(machine.get(memory.mem.index), memory);
  return memory.mem.scale >= 0 ? sum(address, index) : difference(address, index);
}

/// Bytes from one element to the next, of a table that is known to lie at a multiple of them; else 1.
std::uint32_t step_of(const Instruction& i, const cs_arm_op& memory, const Machine& machine) {
  if (memory.mem.index == ARM_REG_INVALID || memory.shift.type != ARM_SFT_LSL) return 1;
  const Interval begin = base_of(i, memory.mem.base, machine).range();
  const std::uint32_t step = 1U << (memory.shift.value & 31U);
  return begin.is_constant() && begin.low % step == 0 ? step : 1;
}

MemoryUse single_use(const Instruction& i, Form form, const Machine& machine) {
  MemoryUse use;
  const cs_arm_op* memory = i.memory();
  if (memory == nullptr) return use;
  use.kind = form.kind;
  const Value address = effective_address(i, *memory, machine);
  const std::size_t place = static_cast<std::size_t>(memory - i.operands.data());
  for (std::size_t o = is_exclusive_store(i.id) ? 1 : 0; o < place; ++o)
    append(use, address, form.size, i.operands[o].reg, step_of(i, *memory, machine));
  if (!i.writes_back) return use;
  Value base = address;
  if (i.operands.size() > place + 1) base = sum(address, operand(i, place + 1, machine));  // post-indexed
  use.base = {memory->mem.base, base};
  return use;
}

/// Load and store multiple: the registers from operand `first` on, upwards from `begin`.
MemoryUse multiple_use(const Instruction& i, Kind kind, std::size_t first, Value begin) {
  MemoryUse use;
  use.kind = kind;
  for (std::size_t o = first; o < i.operands.size(); ++o) append(use, begin, 4, i.operands[o].reg);
  return use;
}

MemoryUse stack_use(const Instruction& i, Kind kind, const Machine& machine) {
  const Value sp = machine.get(ARM_REG_SP);
  const std::uint32_t bytes = 4 * i.words_from(0);
  const Value lower = sum(sp, Value::of(0U - bytes));
  MemoryUse use = multiple_use(i, kind, 0, kind == Kind::store ? lower : sp);
  use.base = {ARM_REG_SP, kind == Kind::store ? lower : sum(sp, Value::of(bytes))};
  return use;
}

MemoryUse block_use(const Instruction& i, Kind kind, bool is_downwards, const Machine& machine) {
  const Value base = base_of(i, i.operands[0].reg, machine);
  const std::uint32_t bytes = 4 * i.words_from(1);
  const Value lower = sum(base, Value::of(0U - bytes));
  MemoryUse use = multiple_use(i, kind, 1, is_downwards ? lower : base);
  if (i.writes_back) use.base = {i.operands[0].reg, is_downwards ? lower : sum(base, Value::of(bytes))};
  return use;
}

}  // namespace

bool is_exclusive_store(unsigned id) { return id == ARM_INS_STREX || id == ARM_INS_STREXB || id == ARM_INS_STREXH; }

bool is_exclusive_load(unsigned id) { return id == ARM_INS_LDREX || id == ARM_INS_LDREXB || id == ARM_INS_LDREXH; }

Value operand(const Instruction& instruction, std::size_t i, const Machine& machine) {
  if (i >= instruction.operands.size()) return Value::in(Interval::any(), true);
  const cs_arm_op& op = instruction.operands[i];
  if (op.type == ARM_OP_IMM) return Value::of(static_cast<std::uint32_t>(op.imm));
  if (op.type != ARM_OP_REG) return Value::in(Interval::any(), true);
  if (op.reg != ARM_REG_PC) return shifted(machine.get(op.reg), op);
  const bool is_address = i == 1 && instruction.has_immediate(2);  // ADR as ADDW, SUBW: ARMv7-M A7.7.7
  return is_address ? base_of(instruction, ARM_REG_PC, machine) : Value::of(instruction.address + 4);
}

MemoryUse memory_use(const Instruction& i, const Machine& machine) {
  switch (i.id) {
    case ARM_INS_PUSH:
    case ARM_INS_VPUSH:
      return stack_use(i, Kind::store, machine);
    case ARM_INS_POP:
    case ARM_INS_VPOP:
      return stack_use(i, Kind::load, machine);
    case ARM_INS_LDM:
    case ARM_INS_VLDMIA:
      return block_use(i, Kind::load, false, machine);
    case ARM_INS_LDMDB:
    case ARM_INS_VLDMDB:
      return block_use(i, Kind::load, true, machine);
    case ARM_INS_STM:
    case ARM_INS_VSTMIA:
      return block_use(i, Kind::store, false, machine);
    case ARM_INS_STMDB:
    case ARM_INS_VSTMDB:
      return block_use(i, Kind::store, true, machine);
    default:
      return single_use(i, form_of(i.id), machine);
  }
}

}  // namespace finemote::gen::wcet
