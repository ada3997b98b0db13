// Parent links to the trees the latency analysis walks.
#pragma once

#include <vector>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

struct Topology {
  std::vector<std::vector<std::size_t>> children;  ///< per device, registration order
  std::vector<std::size_t> roots;                  ///< registration order
  std::vector<std::size_t> root_of;                ///< per device
  std::vector<std::vector<std::size_t>> leaves;    ///< per entry of roots; a root without children is its own leaf
};

/// Requires every parent to be registered after its children.
Topology make_topology(const Model& model);

}  // namespace finemote::gen::timing
