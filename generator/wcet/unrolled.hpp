// All ways through a routine, calls and iterations of loops written out: a graph without cycles.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/image/program.hpp"
#include "generator/wcet/memory_map.hpp"

namespace finemote::gen::wcet {

/// An edge to a node from one before it.
struct UnrolledEdge {
  std::size_t from = 0;
  Cycles cost = 0;  ///< of the way between: refill, first line
};

/// A basic block in one context: one chain of calls, one iteration of each loop around it.
struct UnrolledNode {
  const ProgramFunction* function = nullptr;
  std::uint32_t block = 0;  ///< its first address
  Cycles cost = 0;
  std::vector<UnrolledEdge> from;  ///< only nodes with smaller numbers
};

struct UnrolledGraph {
  std::vector<UnrolledNode> nodes;  ///< the first is the entry
  std::vector<std::size_t> exits;   ///< the routine ends after them
};

}  // namespace finemote::gen::wcet
