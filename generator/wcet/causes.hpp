// A routine that several interrupts of a bus share: how long a run takes by what raised it.
#pragma once

#include <cstdint>
#include <map>

#include "generator/wcet/marks.hpp"
#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// Bits of runtime/include/finemote/raised_by.hpp: one cause or several at once.
using Causes = std::uint32_t;
inline constexpr Causes kRequest = 1, kStep = 2, kEnd = 4, kReceived = 8, kEvent = 16;
inline constexpr Causes kAllCauses = 31;

/// By single cause: no run that it raised takes longer. A cause that no way is left for is not in it.
using CauseTimes = std::map<Causes, Cycles>;

/// A run that serves several causes at once takes no longer than their times together.
CauseTimes times_by_cause(const UnrolledGraph& graph, const Marks& marks);

}  // namespace finemote::gen::wcet
