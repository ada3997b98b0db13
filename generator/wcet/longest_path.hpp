// The longest ways through an unrolled graph, and the proof that none is longer.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// By node: no way from the entry to where the node begins takes longer. A certificate: check_certificate() needs no
/// search to confirm it.
using Potentials = std::vector<Cycles>;

struct LongestPath {
  Potentials potentials;
  Cycles bound = 0;                ///< of the whole routine
  std::vector<std::size_t> nodes;  ///< on a longest way, in order
};

/// From the entry to any exit; none: no way leads out.
std::optional<LongestPath> longest_path(const UnrolledGraph& graph);

/// The longest way from the start of a node in `from` to the start of the first node in `to` that it meets; none: there
/// is no such way. The path ends before the node in `to`.
std::optional<LongestPath> longest_between(const UnrolledGraph& graph, const std::vector<bool>& from,
                                           const std::vector<bool>& to);

}  // namespace finemote::gen::wcet
