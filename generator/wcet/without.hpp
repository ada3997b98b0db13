// A graph without the ways that pass certain places.
#pragma once

#include <cstdint>
#include <set>

#include "generator/wcet/unrolled.hpp"

namespace finemote::gen::wcet {

/// The nodes that are reached from the entry by ways that pass none of `blocks`, in the same order. Without nodes where
/// the entry is one of them.
UnrolledGraph without(const UnrolledGraph& graph, const std::set<std::uint32_t>& blocks);

}  // namespace finemote::gen::wcet
