// Device trees to the languages of other programs that draw graphs.
#pragma once

#include <string>

#include "generator/graph/forest_view.hpp"

namespace finemote::gen {

/// For Graphviz: a box for every device, an arrow from parent to child, dotted from what a device reads, dashed to its
/// bus.
std::string forest_dot(const ForestView& view);

/// For Mermaid, which code hosts draw in Markdown: the same.
std::string forest_mermaid(const ForestView& view);

}  // namespace finemote::gen
