#include "generator/run/mechanics.hpp"

#include <algorithm>
#include <map>

#include "generator/geometry/mass.hpp"
#include "generator/run/emulation.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

Json list(const std::array<double, 3>& values) { return Json{values[0], values[1], values[2]}; }

/// The actuator that drives a joint, where a model of it is on the board.
const Device* driver_of(const Robot& robot, const Joint& joint) {
  for (const Device& device : robot.devices) {
    if (device.type->actuator && has_part(robot, device) && driven_joint(robot, device) == joint.name) return &device;
  }
  return nullptr;
}

Json step_of(const Joint& joint) { return Json{{"xyz", list(joint.origin.xyz)}, {"rpy", list(joint.origin.rpy)}}; }

/// Joints that a part turns, and that do not push the body, with the parts.
std::map<std::string, std::string> turned_joints(const Robot& robot) {
  std::map<std::string, std::string> turned;
  for (const Joint& joint : robot.joints) {
    const bool turns = joint.type == "revolute" || joint.type == "continuous";
    const Device* driver = turns ? driver_of(robot, joint) : nullptr;
    if (driver != nullptr && driver->type->emulation.body.empty()) turned[joint.name] = driver->name.text;
  }
  return turned;
}

bool is_balanced(const Json& joint) {
  const auto c = joint["centre"].get<std::array<double, 3>>(), a = joint["axis"].get<std::array<double, 3>>();
  const Eigen::Vector3d centre(c[0], c[1], c[2]), axis = Eigen::Vector3d(a[0], a[1], a[2]).normalized();
  return joint["mass"] == 0 || centre.cross(axis).norm() < 1e-9;
}

void leave_out_balanced(Json& joints) {
  for (std::size_t i = joints.size(); i-- > 0;) {
    const bool carries = std::any_of(joints.begin(), joints.end(), [&](const Json& other) {
      return other.value("before", std::string()) == joints[i]["part"].get<std::string>();
    });
    if (!carries && is_balanced(joints[i])) joints.erase(i);
  }
}

/// Joints from the body to a link; those from the world to the body say where it starts, not how it is built.
std::optional<std::vector<const Joint*>> way_from_body(const Mechanism& mechanism, const std::string& link) {
  auto way = mechanism.way_to(link);
  const auto above = mechanism.way_to(mechanism.base());
  if (!way || !above) return std::nullopt;
  const auto shared = std::mismatch(way->begin(), way->end(), above->begin(), above->end());
  way->erase(way->begin(), shared.first);
  return way;
}

}  // namespace

std::string body_link(const Robot& robot) { return Mechanism(robot.links, robot.joints).base(); }

Json whole_inertia(const Robot& robot) {
  const Mass sum = mass_behind(Mechanism(robot.links, robot.joints), body_link(robot));
  if (sum.mass <= 0 || sum.inertia.determinant() <= 0) return Json::object();
  const auto& i = sum.inertia;
  return Json{{"mass", sum.mass}, {"inertia", {i(0, 0), i(0, 1), i(0, 2), i(1, 1), i(1, 2), i(2, 2)}}};
}

Json way_to(const Robot& robot, const std::string& link) {
  Json way = Json::array();
  const auto joints = way_from_body(Mechanism(robot.links, robot.joints), link);
  if (!joints) return way;
  for (const Joint* joint : *joints) {
    Json step = step_of(*joint);
    if (const Device* driver = driver_of(robot, *joint)) {
      step["axis"] = list(joint->axis);
      step["part"] = driver->name.text;
    }
    way.push_back(step);
  }
  return way;
}

Json load_of(const Robot& robot, const std::string& name) {
  const Mechanism mechanism(robot.links, robot.joints);
  const Joint* joint = mechanism.joint(name);
  Json load = Json::object();
  if (joint == nullptr) return load;
  const Eigen::Vector3d axis = Eigen::Vector3d(joint->axis[0], joint->axis[1], joint->axis[2]).normalized();
  const double inertia = axis.dot(mass_behind(mechanism, joint->child_link).inertia * axis);
  if (inertia > 0) load["load_inertia"] = inertia;
  if (joint->damping) load["viscous"] = *joint->damping;
  if (joint->friction) load["coulomb"] = *joint->friction;
  if (joint->type == "revolute" && joint->lower) load["lower"] = *joint->lower;
  if (joint->type == "revolute" && joint->upper) load["upper"] = *joint->upper;
  return load;
}

Json hanging_joints(const Robot& robot) {
  const Mechanism mechanism(robot.links, robot.joints);
  const auto turned = turned_joints(robot);
  std::set<std::string> names;
  for (const auto& [joint, part] : turned) names.insert(joint);
  std::map<std::pair<std::size_t, std::string>, Json> by_depth;
  for (const auto& [name, part] : turned) {
    const Joint* joint = mechanism.joint(name);
    const auto way = way_from_body(mechanism, joint->child_link);
    if (!way) continue;
    Json entry{{"part", part}, {"way", Json::array()}};
    for (const Joint* step : *way) {
      entry["way"].push_back(step_of(*step));
      if (step == joint || turned.count(step->name) == 0) continue;
      entry["before"] = turned.at(step->name);
      entry["way"] = Json::array();
    }
    const Mass mass = mass_behind(mechanism, joint->child_link, names);
    entry["axis"] = list(joint->axis);
    entry["mass"] = mass.mass;
    entry["centre"] = {mass.centre().x(), mass.centre().y(), mass.centre().z()};
    by_depth[{way->size(), name}] = entry;
  }
  Json joints = Json::array();
  for (const auto& [depth, entry] : by_depth) joints.push_back(entry);
  leave_out_balanced(joints);
  return joints;
}

}  // namespace finemote::gen
