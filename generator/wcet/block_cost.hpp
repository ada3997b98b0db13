// What a piece of code takes: instructions, the fetch of their lines, and waits for memory.
#pragma once

#include <optional>

#include "generator/image/instruction.hpp"
#include "generator/wcet/cost_table.hpp"
#include "generator/wcet/machine.hpp"
#include "generator/wcet/memory_map.hpp"

namespace finemote::gen::wcet {

class CodeCost {
 public:
  /// @param table  outlives it
  explicit CodeCost(Placement placement, const CostTable& table = documented_costs())
      : placement_(placement), table_(&table) {}

  /// Of an instruction that runs on a machine, without the way to the next; none: it has no known bound.
  [[nodiscard]] std::optional<Cycles> run(const Instruction& instruction, const Machine& machine) const;
  /// The same where its condition does not hold.
  [[nodiscard]] Cycles skip(const Instruction& instruction) const;
  /// To go on at the next instruction.
  [[nodiscard]] Cycles fall(const Instruction& from) const;
  /// To go on at `target` by a branch, a call or a return.
  [[nodiscard]] Cycles jump(std::uint32_t target) const;
  /// A branch that may be taken and is not: its target may have been fetched.
  [[nodiscard]] Cycles not_taken(const Instruction& branch, std::uint32_t target) const;

 private:
  [[nodiscard]] Cycles fetch(const Instruction& instruction) const;
  /// Of an access that need not be aligned: its parts wait each for itself.
  [[nodiscard]] Cycles unaligned_wait(const Access& access) const;
  Placement placement_;
  const CostTable* table_;
};

}  // namespace finemote::gen::wcet
