// The ways out of a basic block.
#pragma once

#include "generator/wcet/step.hpp"

namespace finemote::gen::wcet {

struct BlockEnd {
  const ProgramFunction& function;
  const BasicBlock& block;
  const Surroundings& surroundings;
  const CodeCost& cost;
  const Instruction& last;  ///< of the block
};

/// Adds to `step` the ways that `machine` allows. What the last instruction takes is in the step; it has run on the
/// machine unless it jumps, returns, or calls under a condition.
void add_ways(const BlockEnd& end, Machine machine, Step& step);

}  // namespace finemote::gen::wcet
