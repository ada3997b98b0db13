// Confirms a bound without trust in how it was found.
#pragma once

#include <string>

#include "generator/wcet/longest_path.hpp"

namespace finemote::gen::wcet {

/// Why the potentials do not prove that no way from the entry to an exit takes longer than `bound`; empty: they do. It
/// looks at every edge once: along each, the potential must grow by at least what the node and the edge take (weak
/// duality of longest paths). Shares no code with the search.
std::string check_certificate(const UnrolledGraph& graph, const Potentials& potentials, Cycles bound);

}  // namespace finemote::gen::wcet
