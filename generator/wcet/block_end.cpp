#include "generator/wcet/block_end.hpp"

#include <fmt/format.h>

#include "generator/image/transfer.hpp"
#include "generator/wcet/operands.hpp"
#include "generator/wcet/presumed_return.hpp"

namespace finemote::gen::wcet {
namespace {

using TransferKind = Transfer::Kind;

class Leaving {
 public:
  Leaving(const BlockEnd& end, Machine machine, Step& step) : end_(end), machine_(std::move(machine)), step_(step) {}

  void add() {
    const Instruction& last = end_.last;
    const Transfer transfer = transfer_of(last);
    switch (transfer.kind) {
      case TransferKind::next:
        return end_.block.call ? call(machine_, end_.cost.fall(last)) : edges(machine_, end_.cost.fall(last));
      case TransferKind::call:
      case TransferKind::indirect:
        return call_by(last);
      default:
        return transfer.may_fall_through ? branch(last) : take(last, machine_);
    }
  }

 private:
  /// All edges alike: there is one, which the next instruction follows.
  void edges(const Machine& machine, Cycles cost) {
    for (const FlowEdge& edge : end_.block.edges) step_.ways.push_back({Way::Kind::edge, edge.to, machine, cost});
  }

  /// `bl` was passed as an ordinary instruction, so that the link register is set, unless it is in an IT block.
  void call_by(const Instruction& last) {
    if (!last.is_conditional()) return call_or_jump(machine_);
    Machine taken = machine_, falls = machine_;
    if (taken.assume(last.condition)) {
      execute(last, end_.surroundings, taken);
      call_or_jump(taken);
    }
    if (falls.assume(opposite(last.condition))) fall(last, falls);
  }

  /// A jump within this function, as calls of its parts are, or to another one.
  void call_or_jump(const Machine& machine) {
    if (end_.block.call) return call(machine, 0);
    for (const FlowEdge& edge : end_.block.edges) {
      if (edge.is_taken) step_.ways.push_back({Way::Kind::edge, edge.to, machine, end_.cost.jump(edge.to)});
    }
  }

  /// On where the last instruction does not lead elsewhere.
  void fall(const Instruction& last, const Machine& machine) {
    const Cycles cost = end_.cost.fall(last) + end_.cost.not_taken(last, transfer_of(last).target);
    for (const FlowEdge& edge : end_.block.edges) {
      if (!edge.is_taken) step_.ways.push_back({Way::Kind::edge, edge.to, machine, cost});
    }
  }

  /// By the last instruction, which returns.
  Return returned_by(const Machine& machine) const {
    for (const Transferred& word : memory_use(end_.last, machine).words) {
      if (word.reg == ARM_REG_PC)
        return {machine.stack().load(word.access).anywhere(), !word.access.address.is_on_stack()};
    }
    return by_link(machine);
  }

  static Return by_link(const Machine& machine) {
    return {machine.get(ARM_REG_LR).anywhere(), !machine.is_link_kept()};
  }

  /// To the caller, or to after a call of a part of this function, as far as is known.
  void leave(Machine machine) {
    const Return back = returned_by(machine);
    execute(end_.last, end_.surroundings, machine);
    bool is_one = false;
    for (const FlowEdge& edge : end_.block.edges) {
      if (!edge.is_taken || !back.to.contains(Interval::of(edge.to | 1U))) continue;
      step_.ways.push_back({Way::Kind::edge, edge.to, machine, end_.cost.jump(edge.to)});
      is_one = true;
    }
    if (is_one && back.to.is_constant()) return;
    step_.ways.push_back({Way::Kind::leave, 0, std::move(machine)});
    step_.ways.back().back = back;
  }

  void call(const Machine& machine, Cycles cost) {
    if (!end_.block.call) {
      step_.problem = {end_.block.begin, "a call without a target"};
      return;
    }
    const FlowCall& call = *end_.block.call;
    const auto target = call.target ? call.target : target_of(*end_.function.body.at(call.at), machine);
    if (!target) {
      step_.problem = {call.at, fmt::format("'{}' calls what a variable says", end_.function.body.at(call.at)->text)};
      return go_on_behind(call, machine);
    }
    const bool is_jump = cost == 0;
    Way way{Way::Kind::call, *target & ~1U, machine, is_jump ? end_.cost.jump(*target & ~1U) : cost, call.is_tail};
    if (call.is_tail)
      way.back = by_link(machine);
    else
      way.behind = end_.block.edges.empty() ? 0 : end_.block.edges.front().to;
    step_.ways.push_back(std::move(way));
  }

  void go_on_behind(const FlowCall& call, const Machine& machine) {
    if (!call.is_tail) return edges(presumed_return(machine), 0);
    step_.ways.push_back({Way::Kind::leave, 0, presumed_return(machine)});
  }

  std::optional<std::uint32_t> target_of(const Instruction& i, const Machine& machine) const {
    const Interval range = operand(i, 0, machine).range();
    return range.is_constant() ? std::optional(range.low) : std::nullopt;
  }

  /// Taken or not, as the machine allows.
  void branch(const Instruction& last) {
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
    if (kind == TransferKind::leave) return leave(std::move(machine));
    call_or_jump(machine);
  }

  const BlockEnd& end_;
  Machine machine_;
  Step& step_;
};

}  // namespace

void add_ways(const BlockEnd& end, Machine machine, Step& step) { Leaving(end, std::move(machine), step).add(); }

}  // namespace finemote::gen::wcet
