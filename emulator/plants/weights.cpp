#include "emulator/plants/weights.hpp"

namespace finemote::emulator {

void Weights::step(Time now) {
  struct Standing {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();  ///< the joint's, turned, in the body's
    double mass = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  };
  std::vector<Standing> standing(nodes_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = nodes_[n];
    Eigen::Isometry3d frame = node.before ? standing[*node.before].frame : Eigen::Isometry3d::Identity();
    for (const JointStep& step : node.way) frame = frame * Eigen::Translation3d(step.xyz) * attitude_of(step.rpy);
    standing[n].frame = frame * Eigen::AngleAxisd(node.shaft != nullptr ? node.shaft->angle(now) : 0, node.axis);
    standing[n].mass = node.mass;
    standing[n].moment = node.mass * (standing[n].frame * node.centre);
  }
  const Eigen::Vector3d pull = -body_.motion(now).force;
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Standing& own = standing[n];
    const Eigen::Vector3d lever = own.moment - own.mass * own.frame.translation();
    const double torque = (own.frame.linear() * nodes_[n].axis).dot(lever.cross(pull));
    if (nodes_[n].shaft != nullptr) nodes_[n].shaft->load(now, MotorShaft::Load::weight, torque);
    if (!nodes_[n].before) continue;
    standing[*nodes_[n].before].mass += own.mass;
    standing[*nodes_[n].before].moment += own.moment;
  }
}

}  // namespace finemote::emulator
