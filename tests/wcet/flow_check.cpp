#include "wcet/flow_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>

#include "emulator/core/operation.hpp"

namespace finemote::test {
namespace {

using emulator::Opcode;
using emulator::Operation;

class CoreFlow {
 public:
  /// @param function  that its instructions are read in the order of
  CoreFlow(const gen::Image& image, const gen::ProgramFunction& function) : image_(image) {
    for (const auto& [begin, block] : function.graph.blocks) {
      for (std::uint32_t at = begin; at < block.end;) {
        const Operation o = this->at(at);
        if (o.info.bytes == 0) break;
        before_[at + o.info.bytes] = at;
        at += o.info.bytes;
      }
    }
  }

  [[nodiscard]] Operation at(std::uint32_t address) const {
    return emulator::take_apart(half(address), half(address + 2));
  }

  /// Where the core can go after the instruction, what is after a call included; `from` is the first address after
  /// which it is not conditional by an IT block.
  [[nodiscard]] std::set<std::uint32_t> behind(std::uint32_t address, bool is_conditional) const {
    const Operation o = at(address);
    const std::uint32_t next = address + o.info.bytes, target = address + 4 + o.imm;
    std::set<std::uint32_t> all;
    if (is_conditional) all.insert(next);
    switch (o.kind) {
      case Opcode::b:
        all.insert(target);
        return all;
      case Opcode::b_cond:
      case Opcode::cbz:
      case Opcode::cbnz:
        return {next, target};
      case Opcode::tbb:
      case Opcode::tbh:
        return short_table(address, o.kind == Opcode::tbb ? 1 : 2);
      case Opcode::ldr_reg:
        if (o.d == kPc) return long_table(address);
        break;
      case Opcode::bx:
      case Opcode::mov_pc:
      case Opcode::add_pc:
      case Opcode::undefined:
      case Opcode::bkpt:
        return all;
      default:
        break;
    }
    if (!loads_pc(o)) all.insert(next);
    return all;
  }

 private:
  static bool loads_pc(const Operation& o) {
    if ((o.info.flags & emulator::InstructionInfo::kLoadsPc) != 0) return true;
    return o.kind == Opcode::ldm && (o.imm & 0x8000U) != 0;
  }

  static constexpr std::uint8_t kPc = 15;
  static constexpr unsigned kHigher = 8;  // the condition HI
  static constexpr std::uint32_t kHalf = 2, kWord = 4;

  /// How many entries a table has: the jump is kept from more of them by CMP with the last one, and BHI.
  [[nodiscard]] std::uint32_t entries(std::uint32_t jump, std::uint8_t index) const {
    bool is_guarded = false;
    for (auto at = before_.find(jump); at != before_.end(); at = before_.find(at->second)) {
      const Operation o = this->at(at->second);
      if (o.kind == Opcode::b_cond && o.mode == kHigher) is_guarded = true;
      if (o.kind == Opcode::cmp_imm && o.n == index) return is_guarded ? o.imm + 1 : 0;
    }
    return 0;
  }

  [[nodiscard]] std::set<std::uint32_t> short_table(std::uint32_t jump, std::uint32_t size) const {
    const Operation o = at(jump);
    const std::uint32_t begin = jump + kWord;
    std::set<std::uint32_t> targets;
    for (std::uint32_t entry = 0; entry < entries(jump, o.m); ++entry) {
      const std::uint16_t both = half(begin + (entry * size & ~1U));
      const std::uint32_t halves = size == kHalf ? both : entry % 2 == 0 ? both & 0xFFU : both >> 8U;
      targets.insert(begin + kHalf * halves);
    }
    return targets;
  }

  /// Of addresses: ADR before the jump says where it is.
  [[nodiscard]] std::set<std::uint32_t> long_table(std::uint32_t jump) const {
    const Operation o = at(jump);
    const auto adr = before_.find(jump);
    std::set<std::uint32_t> targets;
    if (adr == before_.end() || at(adr->second).kind != Opcode::adr || at(adr->second).d != o.n) return targets;
    const std::uint32_t begin = ((adr->second + kWord) & ~3U) + at(adr->second).imm;
    for (std::uint32_t entry = 0; entry < entries(jump, o.m); ++entry) {
      const std::uint32_t at = begin + kWord * entry;
      targets.insert((half(at) | static_cast<std::uint32_t>(half(at + kHalf)) << 16U) & ~1U);
    }
    return targets;
  }

  [[nodiscard]] std::uint16_t half(std::uint32_t address) const {
    const std::string_view bytes = image_.bytes(address, 2);
    std::uint16_t value = 0;
    if (bytes.size() == 2) std::memcpy(&value, bytes.data(), 2);
    return value;
  }

  const gen::Image& image_;
  std::map<std::uint32_t, std::uint32_t> before_;  // starts of instructions, by their ends
};

/// The last instruction of a block, and whether an IT block makes it conditional.
std::optional<std::pair<std::uint32_t, bool>> last_of(const CoreFlow& core, const gen::BasicBlock& block) {
  std::uint32_t at = block.begin, last = at, conditional_to = 0;
  while (at < block.end) {
    const Operation o = core.at(at);
    if (o.info.bytes == 0) return std::nullopt;
    last = at;
    at += o.info.bytes;
    if (o.kind != Opcode::it) continue;
    conditional_to = at;
    for (int left = 4 - __builtin_ctz(o.imm & 0xFU); left > 0; --left)
      conditional_to += core.at(conditional_to).info.bytes;
  }
  return std::pair(last, last < conditional_to);
}

}  // namespace

std::vector<std::string> missing_edges(const gen::Image& image, const gen::Program& program,
                                       const gen::ProgramFunction& function, const gen::FlowGraph& graph) {
  const CoreFlow core(image, function);
  std::vector<std::string> missing;
  for (const auto& [begin, block] : graph.blocks) {
    const auto last = last_of(core, block);
    if (!last) {
      missing.push_back(fmt::format("no instruction in the block at {:#x}", begin));
      continue;
    }
    const bool comes_back = !block.call || program.returns(*block.call);
    for (const std::uint32_t to : core.behind(last->first, last->second)) {
      const bool has_edge = std::any_of(block.edges.begin(), block.edges.end(),
                                        [to = to](const gen::FlowEdge& edge) { return edge.to == to; });
      const bool is_call = block.call && block.call->at == last->first;
      const bool is_inside = function.body.contains(to) || (is_call && block.call->is_tail);
      // A call that does not come back, and a jump to another function, which is a tail call.
      if (has_edge || (is_call && !comes_back) || (is_call && block.call->is_tail)) continue;
      missing.push_back(fmt::format("{} from {:#x} to {:#x}", is_inside ? "edge" : "way out", last->first, to));
    }
  }
  return missing;
}

}  // namespace finemote::test
