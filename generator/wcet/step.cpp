#include "generator/wcet/step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/image/transfer.hpp"
#include "generator/wcet/block_end.hpp"
#include "generator/wcet/execute.hpp"
#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

using TransferKind = Transfer::Kind;

bool goes_elsewhere(const Instruction& i) {
  const TransferKind kind = transfer_of(i).kind;
  const bool is_call = kind == TransferKind::call || kind == TransferKind::indirect;
  return kind != TransferKind::next && (!is_call || i.is_conditional());
}

bool writes_constant(const Instruction& i, const Machine& machine, const Constants& constants) {
  const MemoryUse use = memory_use(i, machine);
  return use.kind == MemoryUse::Kind::store &&
         std::any_of(use.words.begin(), use.words.end(), [&](const Transferred& word) {
           return !word.access.address.is_on_stack() && constants.is_broken_by(word.access);
         });
}

class Stepping {
 public:
  Stepping(const ProgramFunction& function, const BasicBlock& block, const Surroundings& surroundings,
           const CodeCost& cost, Machine machine)
      : function_(function), block_(block), surroundings_(surroundings), cost_(cost), machine_(std::move(machine)) {}

  Step result() {
    machine_.set_quotient(std::nullopt);
    const Instruction* last = nullptr;
    for (std::uint32_t address = block_.begin; address < block_.end; address = last->end()) {
      last = function_.body.at(address);
      if (last == nullptr) return fail(address, "no instruction");
      if (last->end() == block_.end && goes_elsewhere(*last)) {
        step_.cost += time(*last, machine_);
        break;
      }
      last = pass(*last);
      if (is_lost_) return std::move(step_);
      if (last->end() < block_.end) step_.cost += cost_.fall(*last);
    }
    add_ways({function_, block_, surroundings_, cost_, *last}, std::move(machine_), step_);
    return std::move(step_);
  }

 private:
  Step fail(std::uint32_t address, std::string why) {
    step_.problem = {address, std::move(why)};
    is_lost_ = true;
    return std::move(step_);
  }

  /// What the instruction takes if it runs on this machine.
  Cycles time(const Instruction& i, const Machine& machine) {
    const auto cycles = cost_.run(i, machine);
    if (!cycles) step_.problem = {i.address, fmt::format("'{}' has no documented longest time", i.text)};
    is_lost_ |= !cycles;
    if (!step_.problem && writes_constant(i, machine, surroundings_.constants))
      step_.problem = {i.address, kStoreToConstant};
    return cycles.value_or(0);
  }

  /// An instruction after which the next follows, or all of an IT block; the last one.
  const Instruction* pass(const Instruction& i) {
    if (i.is_conditional() && i.id != ARM_INS_IT) return pass_either(i);
    step_.cost += time(i, machine_);
    execute(i, surroundings_, machine_);
    return &i;
  }

  /// What one of the two conditions of an IT block leads to.
  struct Side {
    Machine machine;
    bool is_possible;
    Cycles cycles = 0;
  };

  /// Instructions of an IT block run on one side or on the other, and what one side does holds there for the next.
  const Instruction* pass_either(const Instruction& first) {
    Side yes{machine_, true}, no{machine_, true};
    yes.is_possible = yes.machine.assume(first.condition);
    no.is_possible = no.machine.assume(opposite(first.condition));
    std::optional<Comparison> flags = machine_.flags();
    const Instruction* last = &first;
    for (const Instruction* i = &first; i != nullptr; i = next_in_block(*i, first.condition)) {
      if (i != &first) step_.cost += cost_.fall(*last);
      const bool is_yes = i->condition == first.condition;
      run(*i, is_yes ? yes : no);
      (is_yes ? no : yes).cycles += cost_.skip(*i);
      forget_written(*i, flags);
      last = i;
    }
    step_.cost += std::max(yes.is_possible ? yes.cycles : 0, no.is_possible ? no.cycles : 0);
    machine_ = std::move(yes.is_possible ? yes.machine : no.machine);
    if (!yes.is_possible || !no.is_possible) return last;
    machine_.join(no.machine);
    if (flags) machine_.set_flags(flags);
    return last;
  }

  void run(const Instruction& i, Side& side) {
    if (!side.is_possible) return;
    side.cycles += time(i, side.machine);
    execute(i, surroundings_, side.machine);
  }

  /// Another one under the same condition or its opposite; none where the flags are others.
  const Instruction* next_in_block(const Instruction& i, arm_cc condition) const {
    if (i.sets_flags || i.end() >= block_.end) return nullptr;
    const Instruction* next = function_.body.at(i.end());
    if (next == nullptr || next->id == ARM_INS_IT || !next->is_conditional()) return nullptr;
    if (next->end() == block_.end && goes_elsewhere(*next)) return nullptr;
    return next->condition == condition || next->condition == opposite(condition) ? next : nullptr;
  }

  /// What comes after the block may still ask for the same comparison, but not for registers that were written since.
  static void forget_written(const Instruction& i, std::optional<Comparison>& flags) {
    if (i.sets_flags) flags.reset();
    if (!flags) return;
    for (int* reg : {&flags->left, &flags->right, &flags->result}) {
      if (may_write(i, *reg)) *reg = ARM_REG_INVALID;
    }
  }

  const ProgramFunction& function_;
  const BasicBlock& block_;
  const Surroundings& surroundings_;
  const CodeCost& cost_;
  Machine machine_;
  Step step_;
  bool is_lost_ = false;  // there is no knowing what comes after the problem
};

}  // namespace

Step step(const ProgramFunction& function, const BasicBlock& block, const Surroundings& surroundings,
          const CodeCost& cost, Machine machine) {
  return Stepping(function, block, surroundings, cost, std::move(machine)).result();
}

}  // namespace finemote::gen::wcet
