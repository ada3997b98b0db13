// Which marks bound a loop of an image.
#pragma once

#include <cstddef>

#include "generator/image/flow_graph.hpp"
#include "generator/wcet/loop_nest.hpp"
#include "generator/wcet/marks.hpp"

namespace finemote::gen::wcet {

/// `loop_bound<n>()` in a loop itself, not in those in it. A compiler leaves out loops of one round and makes one loop
/// of two, and their marks come to lie in a loop whose marks they are not.
struct LoopMarks {
  std::size_t count = 0;
  bool are_its_own = true;  ///< there is one, and one way back to the begin: nothing says that it is of another loop
};

/// @param index  of a loop of `nest`, which is that of `graph`
LoopMarks marks_of(const FlowGraph& graph, const LoopNest& nest, std::size_t index, const Marks& marks);

}  // namespace finemote::gen::wcet
