#include "generator/geometry/mechanism.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

namespace finemote::gen {
namespace {

template <typename Entry>
const Entry* where(const std::vector<Entry>& list, const std::string Entry::*field, const std::string& value) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Entry& entry) { return entry.*field == value; });
  return found == list.end() ? nullptr : &*found;
}

/// Names ROS gives to what stands still (REP 105, and the habit of simulators).
constexpr std::array<std::string_view, 4> kWorlds{"world", "map", "odom", "earth"};

constexpr double kUpright = M_PI / 180;  // rad: as much as a direction may be off by itself

/// The robot's shadow on the ground (REP 120), with or without a robot's name before it.
bool is_footprint(const std::string& link) {
  constexpr std::string_view name = "base_footprint";
  return link.size() >= name.size() && link.compare(link.size() - name.size(), name.size(), name) == 0;
}

}  // namespace

bool is_world_name(const std::string& link) { return std::find(kWorlds.begin(), kWorlds.end(), link) != kWorlds.end(); }

const Link* Mechanism::link(const std::string& name) const { return where(links_, &Link::name, name); }
const Joint* Mechanism::joint(const std::string& name) const { return where(joints_, &Joint::name, name); }
const Joint* Mechanism::joint_to(const std::string& link) const { return where(joints_, &Joint::child_link, link); }

std::string Mechanism::root() const {
  const auto found =
      std::find_if(links_.begin(), links_.end(), [&](const Link& link) { return joint_to(link.name) == nullptr; });
  return found == links_.end() ? std::string() : found->name;
}

bool Mechanism::is_world(const std::string& name) const {
  const Link* found = link(name);
  const auto carried =
      std::count_if(joints_.begin(), joints_.end(), [&](const Joint& joint) { return joint.parent_link == name; });
  return is_world_name(name) || (found != nullptr && !found->inertial && carried == 1);
}

std::string Mechanism::base() const {
  std::string link = root();
  for (std::size_t steps = 0; steps < joints_.size(); ++steps) {  // joints may form a loop, which is reported elsewhere
    const Joint* joint = is_world(link) ? joint_in_world(link) : nullptr;
    if (joint == nullptr) break;
    link = joint->child_link;
  }
  return link;
}

/// What a world carries by a joint that says where something is in it: the robot, or a world inside.
const Joint* Mechanism::joint_in_world(const std::string& world) const {
  const auto found = std::find_if(joints_.begin(), joints_.end(), [&](const Joint& joint) {
    if (joint.parent_link != world) return false;
    return joint.type == "floating" || joint.type == "planar" ||
           (joint.type == "fixed" && is_world_name(world) && is_world_name(joint.child_link));
  });
  return found == joints_.end() ? nullptr : &*found;
}

/// The joint of a link behind which everything is that moves; without anything that does, its only joint. Null where
/// several are such.
const Joint* Mechanism::joint_of_all_motion(const std::string& link) const {
  std::multimap<std::string_view, const Joint*> joints_of;
  for (const Joint& joint : joints_) joints_of.emplace(joint.parent_link, &joint);
  std::vector<const Joint*> moving, all;
  const auto [begin, end] = joints_of.equal_range(link);
  for (auto it = begin; it != end; ++it) {
    all.push_back(it->second);
    std::vector<const Joint*> stack{it->second};
    for (std::size_t seen = 0; !stack.empty() && seen <= joints_.size(); ++seen) {
      const Joint* joint = stack.back();
      stack.pop_back();
      if (joint->type != "fixed") {
        moving.push_back(it->second);
        break;
      }
      const auto [first, last] = joints_of.equal_range(joint->child_link);
      for (auto below = first; below != last; ++below) stack.push_back(below->second);
    }
  }
  const std::vector<const Joint*>& candidates = moving.empty() ? all : moving;
  return candidates.size() == 1 ? candidates.front() : nullptr;
}

std::string Mechanism::body() const {
  const std::string base_link = base();
  const Joint* joint = is_world_name(base_link) || is_footprint(base_link) ? joint_of_all_motion(base_link) : nullptr;
  if (joint == nullptr || joint->type != "fixed") return base_link;
  const bool upright = transform(joint->origin).linear()(2, 2) >= std::cos(kUpright);
  return upright ? joint->child_link : base_link;
}

std::optional<std::vector<const Joint*>> Mechanism::way_to(const std::string& link) const {
  std::vector<const Joint*> way;
  for (const Joint* joint = joint_to(link); joint != nullptr; joint = joint_to(joint->parent_link)) {
    if (way.size() == joints_.size()) return std::nullopt;
    way.push_back(joint);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<Eigen::Isometry3d> Mechanism::pose(const std::string& link, const std::string& of) const {
  const auto way = way_to(link), way_of = way_to(of);
  if (!way || !way_of) return std::nullopt;
  const auto shared = std::mismatch(way->begin(), way->end(), way_of->begin(), way_of->end());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (auto joint = way_of->rbegin(); joint.base() != shared.second; ++joint)
    pose = pose * transform((*joint)->origin).inverse();
  for (auto joint = shared.first; joint != way->end(); ++joint) pose = pose * transform((*joint)->origin);
  return pose;
}

Eigen::Isometry3d transform(const Pose& pose) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.translate(Eigen::Vector3d(pose.xyz[0], pose.xyz[1], pose.xyz[2]));
  t.rotate(Eigen::AngleAxisd(pose.rpy[2], Eigen::Vector3d::UnitZ()));
  t.rotate(Eigen::AngleAxisd(pose.rpy[1], Eigen::Vector3d::UnitY()));
  t.rotate(Eigen::AngleAxisd(pose.rpy[0], Eigen::Vector3d::UnitX()));
  return t;
}

std::optional<Axis> joint_axis(const Mechanism& mechanism, const std::string& name, const std::string& of) {
  const Joint* joint = mechanism.joint(name);
  if (joint == nullptr) return std::nullopt;
  const Eigen::Vector3d axis(joint->axis[0], joint->axis[1], joint->axis[2]);
  const auto pose = mechanism.pose(joint->child_link, of);
  if (axis.stableNorm() == 0 || !pose) return std::nullopt;
  return Axis{pose->translation(), pose->linear() * axis.stableNormalized()};
}

}  // namespace finemote::gen
