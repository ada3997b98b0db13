#include "generator/wcet/fpu_use.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace finemote::gen::wcet {
namespace {

/// Every mnemonic of the unit begins with this letter, and no other one does: ARMv7-M Architecture Reference Manual
/// A7.7.
bool is_of_fpu(const Instruction& instruction) { return !instruction.text.empty() && instruction.text.front() == 'v'; }

}  // namespace

bool uses_fpu(const UnrolledGraph& graph) {
  std::set<std::pair<const ProgramFunction*, std::uint32_t>> blocks;
  for (const UnrolledNode& node : graph.nodes) blocks.emplace(node.function, node.block);
  return std::any_of(blocks.begin(), blocks.end(), [](const auto& place) {
    const auto& [function, begin] = place;
    if (function == nullptr) return true;  // unknown
    const BasicBlock& block = function->graph.blocks.at(begin);
    const auto& instructions = function->body.instructions();
    return std::any_of(instructions.begin(), instructions.end(), [&](const Instruction& i) {
      return i.address >= block.begin && i.address < block.end && is_of_fpu(i);
    });
  });
}

}  // namespace finemote::gen::wcet
