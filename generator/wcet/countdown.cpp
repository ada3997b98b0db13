#include "generator/wcet/countdown.hpp"

#include "generator/image/transfer.hpp"
#include "generator/wcet/machine.hpp"

namespace finemote::gen::wcet {
namespace {

/// `subs r, #1` is `subs r, r, #1`.
bool subtracts_one(const Instruction& i) {
  const std::size_t left = i.operands.size() > 2 ? 1 : 0;
  if (i.id != ARM_INS_SUB || !i.sets_flags || i.is_conditional() || i.operands.size() < 2) return false;
  const int reg = i.operands[0].reg;
  return i.has_register(0, reg) && i.has_register(left, reg) && Machine::follows(reg) && i.has_immediate(left + 1) &&
         i.immediate(left + 1) == 1;
}

bool returns_unless_zero(const Instruction& i, std::uint32_t begin) {
  const Transfer transfer = transfer_of(i);
  return i.id == ARM_INS_B && i.condition == ARM_CC_NE && transfer.kind == Transfer::Kind::jump &&
         transfer.target == begin;
}

}  // namespace

std::optional<int> counted_down(const ProgramFunction& function, const BasicBlock& block) {
  const Instruction* first = function.body.at(block.begin);
  const Instruction* last = first == nullptr ? nullptr : function.body.at(first->end());
  if (last == nullptr || last->end() != block.end || block.call) return std::nullopt;
  if (!subtracts_one(*first) || !returns_unless_zero(*last, block.begin)) return std::nullopt;
  return first->operands[0].reg;
}

}  // namespace finemote::gen::wcet
