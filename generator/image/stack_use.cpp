#include "generator/image/stack_use.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace finemote::gen {
namespace {

constexpr std::int64_t kDepthLimit = 1 << 16;

/// Bytes that an instruction pushes (positive) or pops; none: unknown.
using StackChange = std::optional<std::int64_t>;

/// Constant of `add sp, #n`, `add sp, sp, #n` and the like; none when it is not a constant or another base.
StackChange constant_of(const Instruction& i) {
  const std::size_t last = i.operands.size() - 1;
  if (!i.has_immediate(last) || (last == 2 && !i.has_register(1, ARM_REG_SP))) return std::nullopt;
  return i.operands[last].imm;
}

/// Loads and stores that move the stack pointer: `str r0, [sp, #-8]!`, `ldr pc, [sp], #4`.
std::int64_t write_back(const Instruction& i) {
  const cs_arm_op* memory = i.memory();
  if (!i.writes_back || memory == nullptr || memory->mem.base != ARM_REG_SP) return 0;
  if (memory->mem.disp != 0) return -memory->mem.disp;
  const auto behind = static_cast<std::size_t>(memory - i.operands.data()) + 1;
  return i.has_immediate(behind) ? -i.operands[behind].imm : 0;
}

StackChange stack_change(const Instruction& i) {
  constexpr std::int64_t kWord = 4;
  const bool moves_stack = i.has_register(0, ARM_REG_SP);
  switch (i.id) {
    case ARM_INS_PUSH:
    case ARM_INS_VPUSH:
      return kWord * i.words_from(0);
    case ARM_INS_POP:
    case ARM_INS_VPOP:
      return -kWord * i.words_from(0);
    case ARM_INS_STMDB:
    case ARM_INS_VSTMDB:
      return moves_stack && i.writes_back ? kWord * i.words_from(1) : 0;
    case ARM_INS_LDM:
    case ARM_INS_VLDMIA:
      return moves_stack && i.writes_back ? -kWord * i.words_from(1) : 0;
    case ARM_INS_SUB:
    case ARM_INS_SUBW:
      return moves_stack ? constant_of(i) : 0;
    case ARM_INS_ADD:
    case ARM_INS_ADDW: {
      if (!moves_stack) return 0;
      const StackChange change = constant_of(i);
      return change ? StackChange(-*change) : std::nullopt;
    }
    case ARM_INS_MOV:
    case ARM_INS_BIC:
    case ARM_INS_AND:
      return moves_stack ? std::nullopt : StackChange(0);
    default:
      return write_back(i);
  }
}

/// Walks every path through a function, each block again only when it is reached with a deeper stack.
class Walk {
 public:
  Walk(const ProgramFunction& function, StackUse& use) : body_(function.body), graph_(function.graph), use_(use) {}

  void from_entry() {
    if (!graph_.problems.empty()) use_.problem = graph_.problems.front().text;
    if (!graph_.blocks.empty()) reach(graph_.entry, 0);
    while (!open_.empty()) {
      const std::uint32_t begin = *open_.begin();
      open_.erase(open_.begin());
      take(graph_.blocks.at(begin), deepest_.at(begin));
    }
    for (const auto& [at, call] : calls_) use_.calls.push_back(call);
  }

 private:
  void reach(std::uint32_t begin, std::int64_t depth) {
    const auto [found, is_new] = deepest_.try_emplace(begin, depth);
    if (!is_new && found->second >= depth) return;
    found->second = depth;
    if (depth > kDepthLimit) {
      use_.problem = "the stack grows in a loop";
      return;
    }
    open_.insert(begin);
  }

  void take(const BasicBlock& block, std::int64_t depth) {
    for (const Instruction* i = body_.at(block.begin); i != nullptr && i->address < block.end; i = body_.at(i->end()))
      depth = after(*i, depth);
    if (block.call) {
      const auto [known, is_new] = calls_.try_emplace(block.call->at, StackUse::Call{*block.call, 0});
      known->second.depth = std::max(known->second.depth, static_cast<std::uint32_t>(depth));
    }
    for (const FlowEdge& edge : block.edges) reach(edge.to, depth);
  }

  std::int64_t after(const Instruction& i, std::int64_t depth) {
    const StackChange change = stack_change(i);
    if (!change) use_.problem = fmt::format("'{}' changes the stack by an unknown amount", i.text);
    const bool may_not_happen = i.is_conditional() && change.value_or(0) < 0;
    depth = std::max<std::int64_t>(depth + (may_not_happen ? 0 : change.value_or(0)), 0);
    use_.depth = std::max(use_.depth, static_cast<std::uint32_t>(depth));
    return depth;
  }

  const FunctionBody& body_;
  const FlowGraph& graph_;
  StackUse& use_;
  std::map<std::uint32_t, std::int64_t> deepest_;
  std::set<std::uint32_t> open_;
  std::map<std::uint32_t, StackUse::Call> calls_;
};

}  // namespace

StackUse stack_use(const ProgramFunction& function) {
  StackUse use;
  Walk(function, use).from_entry();
  return use;
}

}  // namespace finemote::gen
