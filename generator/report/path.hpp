// A chain to the devices whose stages carry it.
#pragma once

#include <vector>

#include "generator/timing/model.hpp"

namespace finemote::gen::report {

struct Path {
  std::vector<Rank> up;    ///< whose update() it takes, from its source to the root of the tree it ends in
  std::vector<Rank> down;  ///< whose handle() it takes, from that root to its end
};

/// The shortest way over parents and `reads`. Requires that data lead from `from` to `to`.
Path path_of(const timing::Model& model, Rank from, Rank to);

}  // namespace finemote::gen::report
