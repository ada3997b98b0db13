#include "generator/run/mechanics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

Eigen::Isometry3d transform(const Pose& pose) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.translate(Eigen::Vector3d(pose.xyz[0], pose.xyz[1], pose.xyz[2]));
  t.rotate(Eigen::AngleAxisd(pose.rpy[2], Eigen::Vector3d::UnitZ()));
  t.rotate(Eigen::AngleAxisd(pose.rpy[1], Eigen::Vector3d::UnitY()));
  t.rotate(Eigen::AngleAxisd(pose.rpy[0], Eigen::Vector3d::UnitX()));
  return t;
}

Json list(const std::array<double, 3>& values) { return Json{values[0], values[1], values[2]}; }

const Joint* joint_to(const Robot& robot, const std::string& child_link) {
  for (const Joint& joint : robot.joints) {
    if (joint.child_link == child_link) return &joint;
  }
  return nullptr;
}

/// The actuator that drives a joint.
const Device* driver_of(const Robot& robot, const Joint& joint) {
  for (const Device& device : robot.devices) {
    if (device.joint == joint.name && device.type->actuator) return &device;
  }
  return nullptr;
}

struct Sum {
  double mass = 0;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the frame's origin
};

/// Adds a link and everything behind it, in the frame `to_frame` leads to.
void add(const Robot& robot, const std::string& link, const Eigen::Isometry3d& to_frame, std::set<std::string>& seen,
         Sum& sum) {
  if (!seen.insert(link).second) return;
  const auto found =
      std::find_if(robot.links.begin(), robot.links.end(), [&](const Link& l) { return l.name == link; });
  if (found != robot.links.end() && found->inertial) {
    const Inertial& own = *found->inertial;
    const Eigen::Isometry3d at = to_frame * transform(own.origin);
    Eigen::Matrix3d inertia;
    inertia << own.inertia[0], own.inertia[1], own.inertia[2], own.inertia[1], own.inertia[3], own.inertia[4],
        own.inertia[2], own.inertia[4], own.inertia[5];
    const Eigen::Vector3d c = at.translation();
    sum.mass += own.mass;
    sum.inertia += at.linear() * inertia * at.linear().transpose() +
                   own.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  }
  for (const Joint& joint : robot.joints) {
    if (joint.parent_link == link) add(robot, joint.child_link, to_frame * transform(joint.origin), seen, sum);
  }
}

Sum sum_behind(const Robot& robot, const std::string& link) {
  Sum sum;
  std::set<std::string> seen;
  add(robot, link, Eigen::Isometry3d::Identity(), seen, sum);
  return sum;
}

}  // namespace

std::string root_link(const Robot& robot) {
  for (const Link& link : robot.links) {
    if (joint_to(robot, link.name) == nullptr) return link.name;
  }
  return {};
}

Json whole_inertia(const Robot& robot) {
  const Sum sum = sum_behind(robot, root_link(robot));
  if (sum.mass <= 0 || sum.inertia.determinant() <= 0) return Json::object();
  const auto& i = sum.inertia;
  return Json{{"mass", sum.mass}, {"inertia", {i(0, 0), i(0, 1), i(0, 2), i(1, 1), i(1, 2), i(2, 2)}}};
}

Json way_to(const Robot& robot, const std::string& link) {
  std::vector<const Joint*> joints;
  for (const Joint* joint = joint_to(robot, link); joint != nullptr && joints.size() < robot.joints.size();
       joint = joint_to(robot, joint->parent_link))
    joints.insert(joints.begin(), joint);
  Json way = Json::array();
  for (const Joint* joint : joints) {
    Json step{{"xyz", list(joint->origin.xyz)}, {"rpy", list(joint->origin.rpy)}};
    if (const Device* driver = driver_of(robot, *joint)) {
      step["axis"] = list(joint->axis);
      step["part"] = driver->name.text;
    }
    way.push_back(step);
  }
  return way;
}

Json load_of(const Robot& robot, const std::string& name) {
  const auto joint =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const Joint& j) { return j.name == name; });
  Json load = Json::object();
  if (joint == robot.joints.end()) return load;
  const Eigen::Vector3d axis = Eigen::Vector3d(joint->axis[0], joint->axis[1], joint->axis[2]).normalized();
  const double inertia = axis.dot(sum_behind(robot, joint->child_link).inertia * axis);
  if (inertia > 0) load["load_inertia"] = inertia;
  if (joint->damping) load["viscous"] = *joint->damping;
  if (joint->friction) load["coulomb"] = *joint->friction;
  if (joint->type == "revolute" && joint->lower) load["lower"] = *joint->lower;
  if (joint->type == "revolute" && joint->upper) load["upper"] = *joint->upper;
  return load;
}

}  // namespace finemote::gen
