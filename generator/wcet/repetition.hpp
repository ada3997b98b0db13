// Loops that an interrupt makes turn once more, because an exclusive store in them fails.
#pragma once

#include "generator/wcet/frame.hpp"

namespace finemote::gen::wcet {

/// What is done again takes longer than the analysis charges the interrupt with: `preemption` in the chip's file. The
/// loop, in which no other one has the store, was gone through by the nodes from `first` on.
bool is_long_repetition(const Frame& frame, std::size_t loop, const UnrolledGraph& graph, std::size_t first);

}  // namespace finemote::gen::wcet
