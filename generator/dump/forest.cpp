#include "generator/dump/dump.hpp"
#include "generator/dump/names.hpp"

namespace finemote::gen {

Json dump_forest(const Robot& robot, const Forest& forest) {
  Json trees = Json::array();
  for (const Tree& tree : forest.trees) {
    trees.push_back({{"root", device_name(robot, tree.root)},
                     {"namespace", tree.space},
                     {"devices", device_names(robot, tree.devices)}});
  }
  return {{"stage", "forest"}, {"trees", trees}, {"order", device_names(robot, forest.order)}};
}

}  // namespace finemote::gen
