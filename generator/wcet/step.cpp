#include "generator/wcet/step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/image/transfer.hpp"
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
    const Instruction* last = nullptr;
    for (std::uint32_t address = block_.begin; address < block_.end; address = last->end()) {
      last = function_.body.at(address);
      if (last == nullptr) return fail(address, "no instruction");
      if (last->end() == block_.end && goes_elsewhere(*last)) break;
      last = pass(*last);
      if (step_.problem) return std::move(step_);
      if (last->end() < block_.end) step_.cost += cost_.fall(*last);
    }
    finish(*last);
    return std::move(step_);
  }

 private:
  Step fail(std::uint32_t address, std::string why) {
    step_.problem = {address, std::move(why)};
    return std::move(step_);
  }

  /// What the instruction takes if it runs on this machine.
  Cycles time(const Instruction& i, const Machine& machine) {
    const auto cycles = cost_.run(i, machine);
    if (!cycles) step_.problem = {i.address, fmt::format("'{}' has no documented longest time", i.text)};
    if (writes_constant(i, machine, surroundings_.constants))
      step_.problem = {i.address, "a store to what is const (a mutable member, or an object that is made anew)"};
    return cycles.value_or(0);
  }

  /// An instruction behind which the next follows, or all of an IT block; the last one.
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

  /// What is behind the block may still ask for the same comparison, but not for registers that were written since.
  static void forget_written(const Instruction& i, std::optional<Comparison>& flags) {
    if (i.sets_flags) flags.reset();
    if (!flags) return;
    for (int* reg : {&flags->left, &flags->right, &flags->result}) {
      if (may_write(i, *reg)) *reg = ARM_REG_INVALID;
    }
  }

  /// The end of the block: the ways from here.
  void finish(const Instruction& last) {
    const Transfer transfer = transfer_of(last);
    switch (transfer.kind) {
      case TransferKind::next:
        return block_.call ? call(machine_, cost_.fall(last)) : edges(cost_.fall(last));
      case TransferKind::call:
      case TransferKind::indirect:
        return call_by(last);
      default:
        return transfer.may_fall_through ? branch(last) : jump(last);
    }
  }

  /// All edges alike: there is one, which the next instruction follows.
  void edges(Cycles cost) {
    for (const FlowEdge& edge : block_.edges) step_.ways.push_back({Way::Kind::edge, edge.to, machine_, cost});
  }

  /// `bl` was passed as an ordinary instruction, so that the link register is set, unless it is in an IT block.
  void call_by(const Instruction& last) {
    if (!last.is_conditional()) return call_or_jump(machine_);
    step_.cost += time(last, machine_);
    Machine taken = machine_, falls = machine_;
    if (taken.assume(last.condition)) {
      execute(last, surroundings_, taken);
      call_or_jump(taken);
    }
    if (falls.assume(opposite(last.condition))) fall(last, falls);
  }

  /// A jump where a part of this function is called.
  void call_or_jump(const Machine& machine) {
    if (block_.call) return call(machine, 0);
    for (const FlowEdge& edge : block_.edges) {
      if (edge.is_taken) step_.ways.push_back({Way::Kind::edge, edge.to, machine, cost_.jump(edge.to)});
    }
  }

  /// On where the last instruction does not lead elsewhere.
  void fall(const Instruction& last, const Machine& machine) {
    const Cycles cost = cost_.fall(last) + cost_.not_taken(last, transfer_of(last).target);
    for (const FlowEdge& edge : block_.edges) {
      if (!edge.is_taken) step_.ways.push_back({Way::Kind::edge, edge.to, machine, cost});
    }
  }

  /// Behind calls of parts of this function, as far as the link register does not say otherwise. True where it says
  /// that.
  bool return_to_part(const Machine& machine) {
    const Interval link = machine.get(ARM_REG_LR).range();
    bool is_one = false;
    for (const FlowEdge& edge : block_.edges) {
      if (!edge.is_taken || !link.contains(Interval::of(edge.to | 1U))) continue;
      step_.ways.push_back({Way::Kind::edge, edge.to, machine, cost_.jump(edge.to)});
      is_one = true;
    }
    return is_one && link.is_constant();
  }

  void call(const Machine& machine, Cycles cost) {
    if (!block_.call) {
      step_.problem = {block_.begin, "a call without a target"};
      return;
    }
    const FlowCall& call = *block_.call;
    const auto target = call.target ? call.target : target_of(*function_.body.at(call.at), machine);
    if (!target) {
      step_.problem = {call.at, fmt::format("'{}' calls what a variable says", function_.body.at(call.at)->text)};
      return;
    }
    const bool is_jump = cost == 0;
    Way way{Way::Kind::call, *target & ~1U, machine, is_jump ? cost_.jump(*target & ~1U) : cost, call.is_tail};
    if (!call.is_tail) way.behind = block_.edges.empty() ? 0 : block_.edges.front().to;
    step_.ways.push_back(std::move(way));
  }

  std::optional<std::uint32_t> target_of(const Instruction& i, const Machine& machine) const {
    const Interval range = operand(i, 0, machine).range();
    return range.is_constant() ? std::optional(range.low) : std::nullopt;
  }

  void jump(const Instruction& last) {
    step_.cost += time(last, machine_);
    take(last, machine_);
  }

  /// Taken or not, as the machine allows.
  void branch(const Instruction& last) {
    step_.cost += time(last, machine_);
    const bool is_on_register = last.id == ARM_INS_CBZ || last.id == ARM_INS_CBNZ;
    arm_cc condition = last.condition;
    const auto flags = machine_.flags();
    if (is_on_register) {
      const int reg = last.operands[0].reg;
      machine_.set_flags(comparison_of(machine_.get(reg), Value::of(0), reg, ARM_REG_INVALID));
      condition = last.id == ARM_INS_CBZ ? ARM_CC_EQ : ARM_CC_NE;
    }
    Machine taken = machine_, falls = machine_;
    const bool is_taken = taken.assume(condition), falls_through = falls.assume(opposite(condition));
    if (is_on_register) {  // which leaves the flags alone
      taken.set_flags(flags);
      falls.set_flags(flags);
    }
    if (is_taken) take(last, taken);
    if (falls_through) fall(last, falls);
  }

  /// Where the last instruction leads when its condition holds.
  void take(const Instruction& last, Machine machine) {
    const TransferKind kind = transfer_of(last).kind;
    if (kind == TransferKind::stop) return;
    if (kind == TransferKind::leave) {
      if (return_to_part(machine)) return;
      execute(last, surroundings_, machine);
      step_.ways.push_back({Way::Kind::leave, 0, std::move(machine)});
      return;
    }
    if (block_.call && block_.call->is_tail) return call(machine, 0);
    for (const FlowEdge& edge : block_.edges) {
      if (edge.is_taken) step_.ways.push_back({Way::Kind::edge, edge.to, machine, cost_.jump(edge.to)});
    }
  }

  const ProgramFunction& function_;
  const BasicBlock& block_;
  const Surroundings& surroundings_;
  const CodeCost& cost_;
  Machine machine_;
  Step step_;
};

}  // namespace

Step step(const ProgramFunction& function, const BasicBlock& block, const Surroundings& surroundings,
          const CodeCost& cost, Machine machine) {
  return Stepping(function, block, surroundings, cost, std::move(machine)).result();
}

}  // namespace finemote::gen::wcet
