// The longest way through a graph, checked.
#pragma once

#include <optional>

#include "generator/wcet/longest_path.hpp"
#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// None where no way leads through it, or the certificate of the longest does not hold.
std::optional<LongestPath> proven_path(const UnrolledGraph& graph);

/// Its length.
std::optional<Cycles> proven_bound(const UnrolledGraph& graph);

}  // namespace finemote::gen::wcet
