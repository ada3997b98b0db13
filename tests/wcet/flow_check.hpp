// The control flow of an image by a second decoder: that of the emulated core.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/program.hpp"

namespace finemote::test {

/// Edges of a function's graph that the core can take and the graph does not have; empty: none.
std::vector<std::string> missing_edges(const gen::Image& image, const gen::Program& program,
                                       const gen::ProgramFunction& function, const gen::FlowGraph& graph);

}  // namespace finemote::test
