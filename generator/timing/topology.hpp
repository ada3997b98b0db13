// Parent links to the trees the latency analysis walks.
#pragma once

#include <vector>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

struct Topology {
  Table<Rank, std::vector<Rank>> children;  ///< registration order
  std::vector<Rank> roots;                  ///< registration order
  Table<Rank, Rank> root_of;
  std::vector<std::vector<Rank>> leaves;  ///< per entry of roots; a root without children is its own leaf
};

/// Requires every parent to be registered after its children.
Topology make_topology(const Model& model);

}  // namespace finemote::gen::timing
