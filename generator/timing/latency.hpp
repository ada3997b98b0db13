// Decision latency of every path and tree: the paper's Theorem 3 and its refinements.
#pragma once

#include "generator/timing/hand_over_store.hpp"
#include "generator/timing/releases.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

/// Per tree, in order of roots. With `corollaries`, also the special-case formulas and the worst pair of leaves
/// (profile paper, whose table has one row per bucket). Throws Overflow.
std::vector<TreeResult> bound_latencies(const Model& model, const Topology& topology, const TaskSet& set,
                                        const Responses& responses, const ReleaseTable& table, bool corollaries,
                                        HandOverStore& store, Effort& effort);

}  // namespace finemote::gen::timing
