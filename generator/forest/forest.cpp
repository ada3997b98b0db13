#include "generator/forest/forest.hpp"

namespace finemote::gen {
namespace {

/// Devices below and including `root`, children first. Iterative: depth is bounded by the input only.
std::vector<DeviceId> leaf_to_root(const Robot& robot, DeviceId root) {
  struct Visit {
    DeviceId device;
    std::size_t next_child = 0;
  };
  std::vector<DeviceId> sequence;
  std::vector<Visit> path{{root}};
  while (!path.empty()) {
    Visit& visit = path.back();
    const auto& children = robot.devices[visit.device].children;
    if (visit.next_child < children.size()) {
      path.push_back({children[visit.next_child++]});
    } else {
      sequence.push_back(visit.device);
      path.pop_back();
    }
  }
  return sequence;
}

}  // namespace

Forest build_forest(const Robot& robot) {
  Forest forest;
  forest.rank.resize(robot.devices.size());
  forest.tree_of.resize(robot.devices.size());
  for (const DeviceId device : robot.devices.ids()) {
    if (robot.devices[device].parent) continue;
    Tree tree{device, robot.devices[device].name.cpp, leaf_to_root(robot, device)};
    for (DeviceId member : tree.devices) {
      forest.rank[member] = forest.order.push_back(member);
      forest.tree_of[member] = forest.trees.size();
    }
    forest.trees.push_back(std::move(tree));
  }
  return forest;
}

}  // namespace finemote::gen
