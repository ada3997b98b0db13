// Loops that an interrupt makes run one more iteration, because an exclusive store in them fails.
#pragma once

#include <set>

#include "generator/wcet/frame.hpp"

namespace finemote::gen::wcet {

inline constexpr const char* kLongRepetition =
    "an interrupt makes it turn once more, which takes too long: its work, and barriers ('memory_order_relaxed' has "
    "none), are to be outside of LDREX and STREX";

/// What an interrupt may have done again [cycles]: fits into `preemption` of the chip's file (wcet_pieces_test).
inline constexpr Cycles kLongestRepetition = 42;

using Blocks = std::set<std::uint32_t>;  ///< by start

bool stores_exclusively(const ProgramFunction& function, const BasicBlock& block);

/// The smallest iteration of a loop with a block, which need not be the only one with this header.
Blocks smallest_turn(const FlowGraph& graph, const Loop& loop, std::uint32_t with);

/// What is done again takes longer than the analysis charges the interrupt with: `preemption` in the chip's file. The
/// loop, in which no other one has the store, was gone through by the nodes from `first` on. Not so where a mark says
/// how often it iterates.
bool is_long_repetition(const Frame& frame, std::size_t loop, const UnrolledGraph& graph, std::size_t first);

}  // namespace finemote::gen::wcet
