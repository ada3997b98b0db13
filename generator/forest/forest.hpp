// Orders the devices of a robot: from parents and children to trees and the one sequence everything runs in.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// One device tree: everything below and including a device without parent.
struct Tree {
  DeviceId root;
  std::string space;              ///< C++ namespace below the robot's: the root's C++ name
  std::vector<DeviceId> devices;  ///< leaf to root: every child before its parent
};

/// The forest of a robot. All sequences follow DESIGN 2, Order: trees by their root's start tag; inside a tree depth
/// first, children in document order, parent last. This is the order of the paper's registration (section 4.1).
struct Forest {
  std::vector<Tree> trees;
  Table<Rank, DeviceId> order;           ///< all devices, tree after tree
  Table<DeviceId, Rank> rank;            ///< where a device stands in `order`
  Table<DeviceId, std::size_t> tree_of;  ///< index into `trees`
};

/// Requires what build_model guarantees: parents exist and form no cycle.
Forest build_forest(const Robot& robot);

}  // namespace finemote::gen
