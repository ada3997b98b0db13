// Follows data through a device tree: for every release of the root, which releases its devices hand over.
#pragma once

#include <functional>

#include "generator/timing/hand_over_store.hpp"
#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

/// Calls `visit` with groups that cover every device of the tree which can be reached through buckets that are ok.
/// Memory and time are bounded: beyond the limits of `effort`, groups have closed forms. Throws Overflow.
void walk_tree(const Model& model, const Topology& topology, const Responses& responses, const TaskSet& set,
               const ReleaseTable& table, Rank root, HandOverStore& store, Effort& effort,
               const std::function<void(const HandOverGroup&)>& visit);

}  // namespace finemote::gen::timing
