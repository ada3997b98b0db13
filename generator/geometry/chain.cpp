#include "generator/geometry/chain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/geometry/mass.hpp"

namespace finemote::gen {

std::string chain_problem(const Mechanism& mechanism, const std::vector<std::string>& joints, std::size_t index) {
  if (index == 0) return {};
  const auto way = mechanism.way_to(mechanism.joint(joints[index])->parent_link);
  const bool follows = way && std::any_of(way->begin(), way->end(),
                                          [&](const Joint* before) { return before->name == joints[index - 1]; });
  return follows ? std::string()
                 : fmt::format("it does not hang behind joint '{}', which comes before it", joints[index - 1]);
}

std::vector<ChainLink> chain(const Mechanism& mechanism, const std::vector<std::string>& joints,
                             const std::string& link) {
  std::vector<ChainLink> links;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto axis = joint_axis(mechanism, joints[i], link);
    const std::string& moved = mechanism.joint(joints[i])->child_link;
    const Mass mass = mass_behind(
        mechanism, moved, i + 1 < joints.size() ? std::set<std::string>{joints[i + 1]} : std::set<std::string>{});
    links.push_back(
        {axis->point - before, axis->direction, mechanism.pose(moved, link)->linear() * mass.centre(), mass.mass});
    before = axis->point;
  }
  return links;
}

}  // namespace finemote::gen
