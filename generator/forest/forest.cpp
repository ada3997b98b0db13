#include "generator/forest/forest.hpp"

namespace finemote::gen {
namespace {

/// Devices below and including `root`, children first. Iterative: depth is bounded by the input only.
std::vector<std::size_t> leaf_to_root(const Robot& robot, std::size_t root) {
  struct Visit {
    std::size_t device;
    std::size_t next_child = 0;
  };
  std::vector<std::size_t> sequence;
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
  for (std::size_t device = 0; device < robot.devices.size(); ++device) {
    if (robot.devices[device].parent) continue;
    Tree tree{device, robot.devices[device].name.cpp, leaf_to_root(robot, device)};
    for (std::size_t member : tree.devices) {
      forest.rank[member] = forest.order.size();
      forest.order.push_back(member);
      forest.tree_of[member] = forest.trees.size();
    }
    forest.trees.push_back(std::move(tree));
  }
  return forest;
}

}  // namespace finemote::gen
