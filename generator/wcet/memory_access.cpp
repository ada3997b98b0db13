#include "generator/wcet/memory_access.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace finemote::gen::wcet {
namespace {

std::uint32_t highest_of(const Access& access) {
  return access.size == 4 ? UINT32_MAX : (1U << (8 * access.size)) - 1U;
}

/// A register that a function keeps for its caller comes back as it was pushed: nobody has the address of that word
/// (AAPCS 6.1.1). Locals are read otherwise.
bool is_restored(const Instruction& i, int reg) {
  const bool is_kept = (reg >= ARM_REG_R4 && reg <= ARM_REG_R11) || reg == ARM_REG_LR;
  return is_kept && i.id == ARM_INS_POP;
}

Value elsewhere(const Access& access, const Surroundings& surroundings, const Machine& machine) {
  const auto constant = surroundings.constants.load(access);
  return constant ? Value::in(*constant) : Value::in({0, highest_of(access)}, machine.has_escaped());
}

/// Once an address has escaped, who preempts this may change any variable of the stack between two instructions.
Value loaded(const Instruction& i, const Transferred& word, const Surroundings& surroundings, const Machine& machine) {
  const Access& access = word.access;
  if (!access.address.may_be_on_stack()) return elsewhere(access, surroundings, machine);
  if (machine.has_escaped() && !is_restored(i, word.reg)) return Value::in({0, highest_of(access)}, true);
  return machine.stack().load(access);
}

Value with_sign(const Access& access, Value value) {
  const bool may_be_negative = value.anywhere().high > highest_of(access) / 2;
  return may_be_negative ? Value::in(Interval::any(), value.is_of_stack) : value;
}

void note(const Access& access, Value value, WordStores& stores) {
  if (access.size != 4 || !access.address.range().is_constant()) return;
  const auto [known, is_new] = stores.try_emplace(access.address.range().low, value.anywhere());
  if (!is_new) known->second = join(known->second, value.anywhere());
}

void store(const Transferred& word, const Surroundings& surroundings, Machine& machine) {
  const Value value =
      Machine::follows(word.reg) ? machine.get(word.reg) : Value::in(Interval::any(), machine.is_stack_in_fpu());
  const Value address = word.access.address;
  if (address.may_be_on_stack()) machine.stack().store(word.access, value);
  if (address.is_on_stack()) return;
  if (value.is_of_stack) machine.escape();
  if (surroundings.stores != nullptr) note(word.access, value, *surroundings.stores);
}

/// It succeeds after the load that it belongs to if no exception comes between the two: ARMv7-M A3.4.1.
void store_exclusive(const Instruction& i, const Surroundings& surroundings, Machine& machine) {
  const bool may_fail = surroundings.exclusive_may_fail || machine.may_fail_exclusive();
  machine.set(i.operands[0].reg, may_fail ? Value::in({0, 1}) : Value::of(0));
  machine.set_exclusive(true);
}

}  // namespace

void access_memory(const Instruction& i, const MemoryUse& use, const Surroundings& surroundings, Machine& machine) {
  std::vector<std::pair<int, Value>> loads;
  for (const Transferred& word : use.words) {
    if (use.kind == MemoryUse::Kind::store) {
      store(word, surroundings, machine);
      continue;
    }
    const Value value = loaded(i, word, surroundings, machine);
    if (Machine::follows(word.reg)) {
      const bool is_signed = use.kind == MemoryUse::Kind::load_signed;
      loads.emplace_back(word.reg, is_signed ? with_sign(word.access, value) : value);
    } else if (value.is_of_stack && word.reg != ARM_REG_PC) {
      machine.put_stack_in_fpu();
    }
  }
  if (use.base) machine.set(use.base->first, use.base->second);
  for (const auto& [reg, value] : loads) machine.set(reg, value);
  const auto keeps_link = [](const Transferred& word) {
    return word.reg == ARM_REG_LR && word.access.address.is_on_stack();
  };
  if (use.kind != MemoryUse::Kind::store && std::any_of(use.words.begin(), use.words.end(), keeps_link))
    machine.keep_link();
  if (is_exclusive_load(i.id)) machine.set_exclusive(false);
  if (is_exclusive_store(i.id)) store_exclusive(i, surroundings, machine);
}

}  // namespace finemote::gen::wcet
