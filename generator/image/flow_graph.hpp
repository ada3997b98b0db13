// The control flow of one function: basic blocks and the edges between them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/image/body.hpp"
#include "generator/image/image.hpp"

namespace finemote::gen {

struct FlowCall {
  std::uint32_t at = 0;                 ///< address of the instruction
  std::optional<std::uint32_t> target;  ///< none: through a register
  bool is_tail = false;                 ///< a jump: its callee returns to the caller of this function
};

struct FlowEdge {
  std::uint32_t to = 0;   ///< start of a block
  bool is_taken = false;  ///< by a branch; otherwise the next block, or what follows a call that returned
};

/// Instructions that run one after the other: only the first is jumped to, only the last jumps or calls.
struct BasicBlock {
  std::uint32_t begin = 0, end = 0;
  std::vector<FlowEdge> edges;
  std::optional<FlowCall> call;  ///< of the last instruction
  bool leaves = false;           ///< the last instruction may return to the caller
};

/// Why a place has no known continuation.
struct FlowProblem {
  std::uint32_t address = 0;
  std::string text;
};

struct FlowGraph {
  std::uint32_t entry = 0;
  std::map<std::uint32_t, BasicBlock> blocks;  ///< by their starts, those that are reached from the entry
  std::vector<FlowProblem> problems;

  /// Some path ends in a return or in a tail call that `returns`.
  [[nodiscard]] bool has_return(const std::function<bool(const FlowCall&)>& returns) const;
};

/// Where a trace begins and what cuts its blocks.
struct TraceLimits {
  std::uint32_t entry = 0;                ///< an instruction of the body, mostly its first
  std::vector<std::uint32_t> boundaries;  ///< addresses at which blocks end, too, in order; may lie anywhere
};

/// A call of a place in the same body is a jump there, from which a return may lead to the place after the call: so do
/// routines of libgcc, parts of which also return for the whole.
/// @param returns  whether a call comes back; after one that does not, nothing is followed
FlowGraph trace(const Image& image, const FunctionBody& body, const std::function<bool(const FlowCall&)>& returns,
                const TraceLimits& limits);

}  // namespace finemote::gen
