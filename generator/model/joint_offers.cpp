// Joints that a device without one may have been meant for: text for hints.
#include <algorithm>
#include <cctype>
#include <set>

#include "generator/geometry/fit.hpp"
#include "generator/geometry/frame.hpp"
#include "generator/geometry/range.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

using Words = std::set<std::string>;

/// Of two letters or more; `joint` says nothing.
Words words_of(const std::string& name) {
  Words words;
  std::string word;
  for (const char c : name + "_") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else {
      if (word.size() > 1 && word != "joint") words.insert(word);
      word.clear();
    }
  }
  return words;
}

Words common(const Words& one, const Words& other) {
  Words both;
  std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::inserter(both, both.end()));
  return both;
}

std::string without_digits(std::string name) {
  name.erase(std::remove_if(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; }),
             name.end());
  return name;
}

/// Joints of the children that have the role.
std::vector<std::string> siblings(const Reading& reading, const Device& parent, const std::string& role) {
  std::vector<std::string> joints;
  for (const DeviceId child : parent.children) {
    const Device& device = reading.robot.devices[child];
    const bool is_meant = device.role && parent.type->roles[*device.role].name == role;
    if (is_meant && reading.kinematics.joint(device.joint) != nullptr) joints.push_back(device.joint);
  }
  return joints;
}

bool is_driven(const Reading& reading, const Joint& joint) {
  return std::any_of(reading.robot.devices.begin(), reading.robot.devices.end(),
                     [&](const Device& device) { return device.joint == joint.name; });
}

/// It turns by itself, and could stand after the siblings in everything that is computed of the role.
bool fits(const Reading& reading, const Device& parent, const std::string& role, const Joint& joint) {
  if (!turns(joint) || !joint.mimic.empty() || is_driven(reading, joint)) return false;
  const Mechanism mechanism(reading.kinematics.links, reading.kinematics.joints);
  std::vector<std::string> joints = siblings(reading, parent, role);
  joints.push_back(joint.name);
  for (const GeometrySpec& geometry : parent.type->geometry) {
    if (geometry.role != role) continue;
    const std::string link = geometry_link(mechanism, parent.link, geometry, joints);
    const Placement placement = place(mechanism, geometry, link, joints, {}, geometry_param(parent.params, geometry));
    if (!joint_problems(placement).back().empty()) return false;
  }
  return true;
}

/// Its name is one of the family: it has the words that all siblings have, or differs from one in its number.
bool is_alike(const std::string& joint, const std::vector<std::string>& siblings, const std::string& child) {
  if (joint.find(child) != std::string::npos) return true;
  Words family = words_of(siblings.empty() ? child : siblings.front());
  for (const std::string& sibling : siblings) {
    if (without_digits(sibling) == without_digits(joint)) return true;
    family = common(family, words_of(sibling));
  }
  return !common(family, words_of(joint)).empty();
}

}  // namespace

std::vector<std::string> offered_joints(const Reading& reading, const Device& parent, const std::string& role,
                                        const std::string& child, bool only_alike) {
  std::vector<std::string> alike, others;
  const std::vector<std::string> family = siblings(reading, parent, role);
  for (const Joint& joint : reading.kinematics.joints) {
    if (fits(reading, parent, role, joint))
      (is_alike(joint.name, family, child) ? alike : others).push_back(joint.name);
  }
  std::stable_partition(alike.begin(), alike.end(),
                        [&](const std::string& joint) { return joint.find(child) != std::string::npos; });
  return alike.empty() && !only_alike ? others : alike;
}

}  // namespace finemote::gen
