#include "emulator/plants/weights.hpp"

namespace finemote::emulator {

void Weights::step(Time now) {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = nodes_[n];
    Eigen::Isometry3d frame = node.before ? standing_[*node.before].frame : Eigen::Isometry3d::Identity();
    for (const JointStep& step : node.way) frame = frame * Eigen::Translation3d(step.xyz) * attitude_of(step.rpy);
    standing_[n].frame = frame * Eigen::AngleAxisd(node.shaft != nullptr ? node.shaft->angle(now) : 0, node.axis);
    standing_[n].mass = node.mass;
    standing_[n].moment = node.mass * (standing_[n].frame * node.centre);
  }
  const Eigen::Vector3d pull = -body_.motion(now).force;
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Standing& own = standing_[n];
    const Eigen::Vector3d lever = own.moment - own.mass * own.frame.translation();
    const double torque = (own.frame.linear() * nodes_[n].axis).dot(lever.cross(pull));
    if (nodes_[n].shaft != nullptr) nodes_[n].shaft->load(now, MotorShaft::Load::weight, torque);
    if (!nodes_[n].before) continue;
    standing_[*nodes_[n].before].mass += own.mass;
    standing_[*nodes_[n].before].moment += own.moment;
  }
}

}  // namespace finemote::emulator
