#include "generator/geometry/mass.hpp"

namespace finemote::gen {
namespace {

void add(const Inertial& own, const Eigen::Isometry3d& to_frame, Mass& sum) {
  const Eigen::Isometry3d at = to_frame * transform(own.origin);
  const auto& i = own.inertia;
  Eigen::Matrix3d inertia;
  inertia << i[0], i[1], i[2], i[1], i[3], i[4], i[2], i[4], i[5];
  const Eigen::Vector3d c = at.translation();
  sum.mass += own.mass;
  sum.moment += own.mass * c;
  sum.inertia += at.linear() * inertia * at.linear().transpose() +
                 own.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
}

}  // namespace

Mass mass_behind(const Mechanism& mechanism, const std::string& link, const std::set<std::string>& but) {
  Mass sum;
  std::set<std::string> seen{link};
  std::vector<std::pair<std::string, Eigen::Isometry3d>> open{{link, Eigen::Isometry3d::Identity()}};
  while (!open.empty()) {
    const auto [name, to_frame] = open.back();
    open.pop_back();
    const Link* found = mechanism.link(name);
    if (found != nullptr && found->inertial) add(*found->inertial, to_frame, sum);
    for (const Joint& joint : mechanism.joints()) {
      if (joint.parent_link != name || but.count(joint.name) != 0 || !seen.insert(joint.child_link).second) continue;
      open.emplace_back(joint.child_link, to_frame * transform(joint.origin));
    }
  }
  return sum;
}

}  // namespace finemote::gen
