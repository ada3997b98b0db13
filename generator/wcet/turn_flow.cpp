#include "generator/wcet/turn_flow.hpp"

#include <algorithm>
#include <map>

#include "generator/wcet/operands.hpp"

namespace finemote::gen::wcet {
namespace {

using Registers = std::set<int>;
using Turn = std::set<std::uint32_t>;

/// How an instruction uses the first of its registers.
enum class First { read, changed, made };

First use_of_first(const Instruction& i) {
  switch (i.id) {
    case ARM_INS_ADD:
    case ARM_INS_AND:
    case ARM_INS_BIC:
    case ARM_INS_EOR:
    case ARM_INS_ORN:
    case ARM_INS_ORR:
    case ARM_INS_RSB:
    case ARM_INS_SUB:
    case ARM_INS_LSL:
    case ARM_INS_LSR:
    case ARM_INS_ASR:
      return i.operands.size() > 2 && !i.is_conditional() ? First::made : First::changed;
    case ARM_INS_MOV:
    case ARM_INS_MOVW:
    case ARM_INS_MVN:
    case ARM_INS_LDR:
    case ARM_INS_LDRB:
    case ARM_INS_LDRH:
    case ARM_INS_UXTB:
    case ARM_INS_UXTH:
      return i.is_conditional() ? First::changed : First::made;
    default:  // whether an exclusive store has failed is asked for under its own condition
      if (is_exclusive_store(i.id)) return First::made;
      return is_exclusive_load(i.id) && !i.is_conditional() ? First::made : First::read;
  }
}

bool writes_memory(const Instruction& i) {
  switch (i.id) {
    case ARM_INS_STR:
    case ARM_INS_STRB:
    case ARM_INS_STRH:
    case ARM_INS_STRD:
    case ARM_INS_STM:
    case ARM_INS_STMDB:
    case ARM_INS_PUSH:
    case ARM_INS_VSTR:
    case ARM_INS_VSTMIA:
    case ARM_INS_VSTMDB:
    case ARM_INS_VPUSH:
      return true;
    default:
      return !i.is_known();
  }
}

Registers read_by(const Instruction& i) {
  Registers read;
  for (std::size_t o = use_of_first(i) == First::made ? 1 : 0; o < i.operands.size(); ++o) {
    const cs_arm_op& op = i.operands[o];
    if (op.type == ARM_OP_REG) read.insert(op.reg);
    if (op.type == ARM_OP_MEM) read.insert({static_cast<int>(op.mem.base), static_cast<int>(op.mem.index)});
  }
  read.erase(ARM_REG_INVALID);
  return read;
}

Registers written_by(const Instruction& i) {
  Registers written;
  const cs_arm_op* memory = i.memory();
  if (i.writes_back && memory != nullptr) written.insert(memory->mem.base);
  for (const cs_arm_op& op : i.operands) {
    const bool is_result = use_of_first(i) == First::read || &op == i.operands.data();
    if (op.type == ARM_OP_REG && is_result && may_write(i, op.reg)) written.insert(op.reg);
  }
  return written;
}

bool meets(const Registers& a, const Registers& b) {
  return std::any_of(a.begin(), a.end(), [&](int reg) { return b.count(reg) != 0; });
}

/// One iteration, followed instruction by instruction.
class Following {
 public:
  Following(const ProgramFunction& function, const Turn& turn, std::uint32_t header)
      : function_(function), turn_(turn), header_(header) {}

  TurnFlow result() {
    TurnFlow flow;
    for (const std::uint32_t begin : turn_) {
      flow.accumulates |= block(begin).call.has_value();
      each(begin, [&](const Instruction& i) {
        flow.accumulates |= writes_memory(i) && !is_exclusive_store(i.id);
        written_.merge(written_by(i));
      });
    }
    const Registers read = read_first();
    std::set_intersection(read.begin(), read.end(), written_.begin(), written_.end(),
                          std::inserter(flow.carried, flow.carried.end()));
    flow.accumulates |= is_made_of_itself(flow.carried);
    return flow;
  }

 private:
  [[nodiscard]] const BasicBlock& block(std::uint32_t begin) const { return function_.graph.blocks.at(begin); }
  template <class Visit>
  void each(std::uint32_t begin, const Visit& visit) const {
    const std::uint32_t end = block(begin).end;
    for (const Instruction* i = function_.body.at(begin); i != nullptr && i->address < end;
         i = function_.body.at(i->end()))
      visit(*i);
  }

  /// What a block reads before it writes it, if the blocks after it read `behind`.
  [[nodiscard]] Registers read_in(std::uint32_t begin, const Registers& behind) const {
    Registers made, read;
    const auto take = [&](int reg) {
      if (made.count(reg) == 0) read.insert(reg);
    };
    each(begin, [&](const Instruction& i) {
      for (const int reg : read_by(i)) take(reg);
      if (use_of_first(i) == First::made && !i.is_conditional()) made.merge(written_by(i));
    });
    for (const int reg : behind) take(reg);
    return read;
  }

  /// What the iteration reads before it has written it.
  [[nodiscard]] Registers read_first() const {
    std::map<std::uint32_t, Registers> read;
    for (bool is_new = true; is_new;) {
      is_new = false;
      for (const std::uint32_t begin : turn_) {
        Registers behind;
        for (const FlowEdge& edge : block(begin).edges) {
          if (edge.to != header_ && turn_.count(edge.to) != 0)
            behind.insert(read[edge.to].begin(), read[edge.to].end());
        }
        Registers here = read_in(begin, behind);
        is_new |= here != read[begin];
        read[begin] = std::move(here);
      }
    }
    return read[header_];
  }

  /// Registers made of `made_of`, after a block.
  [[nodiscard]] Registers made_behind(std::uint32_t begin, Registers made_of) const {
    each(begin, [&](const Instruction& i) {
      const bool is_made_of = meets(read_by(i), made_of);
      const bool is_kept = i.is_conditional() && !is_exclusive_store(i.id);
      for (const int reg : written_by(i)) {
        if (is_made_of && !is_exclusive_store(i.id)) made_of.insert(reg);
        if (!is_made_of && !is_kept && use_of_first(i) != First::changed) made_of.erase(reg);
      }
    });
    return made_of;
  }

  /// What an iteration leaves in some of these registers is made of what was in some of them.
  [[nodiscard]] bool is_made_of_itself(const Registers& carried) const {
    std::map<std::uint32_t, Registers> made{{header_, carried}};
    bool comes_back = false;
    for (bool is_new = true; is_new;) {
      is_new = false;
      for (const std::uint32_t begin : turn_) {
        const Registers behind = made_behind(begin, made[begin]);
        for (const FlowEdge& edge : block(begin).edges) {
          if (edge.to == header_) comes_back |= meets(behind, carried);
          if (edge.to == header_ || turn_.count(edge.to) == 0) continue;
          const std::size_t known = made[edge.to].size();
          made[edge.to].insert(behind.begin(), behind.end());
          is_new |= made[edge.to].size() != known;
        }
      }
    }
    return comes_back;
  }

  const ProgramFunction& function_;
  const Turn& turn_;
  const std::uint32_t header_;
  Registers written_;
};

}  // namespace

TurnFlow turn_flow(const ProgramFunction& function, const std::set<std::uint32_t>& turn, std::uint32_t header) {
  return Following(function, turn, header).result();
}

}  // namespace finemote::gen::wcet
