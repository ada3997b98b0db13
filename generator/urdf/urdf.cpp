#include "generator/urdf/urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/diagnostic/code_urdf.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/urdf/elements.hpp"
#include "generator/urdf/urdfdom_check.hpp"

namespace finemote::gen {
namespace {

template <typename List>
auto find_by_name(const List& list, std::string_view name) -> decltype(&list.front()) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
  return found == list.end() ? nullptr : &*found;
}

using Need = ElementReader::Need;

bool has_end(const std::string& type) { return type == "revolute" || type == "prismatic"; }

void read_limit(const xml::Node& tag, Joint& joint, ElementReader& reader) {
  const xml::Node* limit = reader.child(tag, "limit", has_end(joint.type) ? Need::by_ros : Need::optional);
  if (limit == nullptr) return;
  joint.lower = reader.number(*limit, "lower");
  joint.upper = reader.number(*limit, "upper");
  joint.effort = reader.number(*limit, "effort", Need::by_ros);
  joint.velocity = reader.number(*limit, "velocity", Need::by_ros);
}

void read_dynamics(const xml::Node& tag, Joint& joint, ElementReader& reader) {
  const xml::Node* dynamics = reader.child(tag, "dynamics");
  if (dynamics == nullptr) return;
  joint.damping = reader.number(*dynamics, "damping");
  joint.friction = reader.number(*dynamics, "friction");
}

std::optional<Inertial> read_inertial(const xml::Node& link, ElementReader& reader) {
  const xml::Node* tag = reader.child(link, "inertial");
  if (tag == nullptr) return std::nullopt;
  Inertial inertial;
  inertial.origin = reader.origin(*tag);
  if (const xml::Node* mass = reader.child(*tag, "mass", Need::by_ros))
    inertial.mass = reader.amount(*mass, "value", 0);
  if (const xml::Node* inertia = reader.child(*tag, "inertia", Need::by_ros)) {
    constexpr const char* kMoments[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    for (std::size_t i = 0; i < inertial.inertia.size(); ++i)
      inertial.inertia[i] = reader.amount(*inertia, kMoments[i], -kLargestInUrdf);
  }
  return inertial;
}

void read_type(const xml::Node& tag, Joint& joint, ElementReader& reader) {
  const xml::Attribute* type = reader.attribute(tag, "type", Need::strict);
  if (type == nullptr) return;
  joint.type = type->value;
  const std::vector<std::string> known{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
  if (std::find(known.begin(), known.end(), joint.type) != known.end()) return;
  reader.mistake(code::joint_type, type->value_at, fmt::format("unknown joint type '{}'", joint.type))
      .underline(joint.type.size())
      .hint(did_you_mean(joint.type, known));
}

/// Reads `<parent link="..."/>` or `<child link="..."/>`; the link has to exist.
std::string read_end(const xml::Node& tag, std::string_view which, const std::vector<Link>& links,
                     ElementReader& reader) {
  const xml::Node* end = reader.child(tag, which, Need::strict);
  const xml::Attribute* link = end == nullptr ? nullptr : reader.attribute(*end, "link", Need::strict);
  if (link == nullptr) return {};
  if (find_by_name(links, link->value) == nullptr) {
    std::vector<std::string> names;
    for (const Link& candidate : links) names.push_back(candidate.name);
    auto& finding =
        reader.mistake(code::unknown_link, link->value_at, fmt::format("there is no link '{}'", link->value))
            .underline(link->value.size());
    if (!names.empty()) finding.hint(did_you_mean(link->value, names));
  }
  return link->value;
}

template <typename Entry>
void report_duplicates(const std::vector<Entry>& list, std::string_view what, std::set<std::string, std::less<>>& wrong,
                       Diagnostics& diagnostics) {
  std::map<std::string_view, const Entry*> seen;
  for (const Entry& entry : list) {
    const auto [first, fresh] = seen.emplace(entry.name, &entry);
    if (fresh) continue;
    wrong.insert(entry.name);
    diagnostics.error(code::duplicate_in_urdf, entry.at, fmt::format("there are two {}s '{}'", what, entry.name))
        .underline(what.size() + 1)
        .note("the first one is declared here", first->second->at);
  }
}

void report_second_parents(Kinematics& kinematics, Diagnostics& diagnostics) {
  std::map<std::string_view, const Joint*> parent;
  for (const Joint& joint : kinematics.joints) {
    if (joint.child_link.empty()) continue;
    const auto [first, fresh] = parent.emplace(joint.child_link, &joint);
    if (fresh) continue;
    kinematics.wrong_joints.insert(joint.name);
    kinematics.wrong_joints.insert(first->second->name);
    diagnostics
        .error(code::link_parents, joint.at, fmt::format("link '{}' is the child of two joints", joint.child_link))
        .underline(6)
        .note(fmt::format("also of joint '{}'", first->second->name), first->second->at);
  }
}

/// Every link has one parent at most: a way up that meets itself has found a loop. urdfdom overlooks loops beside a
/// tree.
void report_loops(const std::vector<Joint>& joints, Diagnostics& diagnostics) {
  std::map<std::string, const Joint*> carried_by;
  for (const Joint& joint : joints) carried_by.emplace(joint.child_link, &joint);
  std::map<std::string, const Joint*> passed;  // link -> the joint whose way up passed it first
  for (const Joint& start : joints) {
    std::string link = start.child_link;
    while (carried_by.count(link) > 0 && passed.emplace(link, &start).second) link = carried_by.at(link)->parent_link;
    if (carried_by.count(link) == 0 || passed.at(link) != &start) continue;
    std::string way = fmt::format("'{}'", link), next = link;
    do {
      next = carried_by.at(next)->parent_link;
      way += fmt::format(" <- '{}'", next);
    } while (next != link);
    diagnostics.error(code::urdf_rejected, carried_by.at(link)->at, "the joints of this robot form a loop")
        .underline(6)
        .note("each link is carried by the next: " + way)
        .note("links and joints form a tree below one root link");
  }
}

void read_link(const xml::Node& tag, Kinematics& kinematics, Diagnostics& diagnostics) {
  ElementReader reader(ElementReader::Owner::link, tag, diagnostics);
  const xml::Attribute* name = reader.attribute(tag, "name", Need::strict);
  if (name == nullptr) return;
  kinematics.links.push_back({name->value, tag.at, read_inertial(tag, reader)});
  if (reader.is_wrong()) kinematics.wrong_links.insert(name->value);
  for (Doubt& doubt : reader.take_doubts()) kinematics.doubts.push_back(std::move(doubt));
}

void read_joint(const xml::Node& tag, Kinematics& kinematics, Diagnostics& diagnostics) {
  ElementReader reader(ElementReader::Owner::joint, tag, diagnostics);
  Joint joint;
  joint.at = tag.at;
  if (const xml::Attribute* name = reader.attribute(tag, "name", Need::strict)) joint.name = name->value;
  read_type(tag, joint, reader);
  joint.parent_link = read_end(tag, "parent", kinematics.links, reader);
  joint.child_link = read_end(tag, "child", kinematics.links, reader);
  joint.origin = reader.origin(tag);
  const xml::Node* axis = reader.child(tag, "axis");
  const auto xyz = axis == nullptr ? std::nullopt : reader.numbers(*axis, "xyz", 3);
  if (xyz) std::copy(xyz->begin(), xyz->end(), joint.axis.begin());
  if (!xyz) kinematics.default_axes.insert(joint.name);
  read_limit(tag, joint, reader);
  read_dynamics(tag, joint, reader);
  if (const xml::Node* mimic = reader.child(tag, "mimic")) {
    if (const xml::Attribute* leader = reader.attribute(*mimic, "joint", Need::by_ros)) joint.mimic = leader->value;
  }
  if (reader.is_wrong()) kinematics.wrong_joints.insert(joint.name);
  for (Doubt& doubt : reader.take_doubts()) kinematics.doubts.push_back(std::move(doubt));
  kinematics.joints.push_back(std::move(joint));
}

bool has_child(const xml::Node& node, std::string_view tag) {
  return std::any_of(node.children.begin(), node.children.end(),
                     [&](const xml::Node& child) { return child.is_element(tag); });
}

/// `<Joint name="...">`, `<lnik name="...">`: ROS tools skip it silently, and all that hangs on it is lost.
bool is_misspelt(const xml::Node& node, std::string_view meant) {
  if (!node.is_element() || node.attribute("name") == nullptr || !is_mistyped(node.name, meant)) return false;
  if (meant == "joint") return has_child(node, "parent") || has_child(node, "child");
  const bool is_plain = std::none_of(node.children.begin(), node.children.end(),
                                     [](const xml::Node& child) { return child.is_element(); });
  return is_plain || has_child(node, "inertial") || has_child(node, "visual") || has_child(node, "collision");
}

/// An element of the robot that is a `<link>` or `<joint>`, or was meant to be, which is reported.
bool is_part(const xml::Node& node, const char* what, Diagnostics& diagnostics) {
  if (!is_misspelt(node, what)) return node.is_element(what);
  diagnostics.error(code::urdf_misspelt, node.at, fmt::format("unknown element <{}> in <robot>", node.name))
      .underline(node.name.size() + 1)
      .note("ROS tools skip it silently")
      .hint(fmt::format("did you mean <{}>?", what));
  return true;
}

}  // namespace

const Link* Kinematics::link(std::string_view name) const { return find_by_name(links, name); }
const Joint* Kinematics::joint(std::string_view name) const { return find_by_name(joints, name); }

Kinematics read_urdf(const xml::Node& robot, Diagnostics& diagnostics) {
  const std::size_t findings = diagnostics.size();
  Kinematics kinematics;
  for (const xml::Node& child : robot.children) {
    if (is_part(child, "link", diagnostics)) read_link(child, kinematics, diagnostics);
  }
  for (const xml::Node& child : robot.children) {
    // `<joint>` of a transmission stands deeper; one with only a name here belongs to another extension
    if (is_part(child, "joint", diagnostics)) read_joint(child, kinematics, diagnostics);
  }
  report_duplicates(kinematics.links, "link", kinematics.wrong_links, diagnostics);
  report_duplicates(kinematics.joints, "joint", kinematics.wrong_joints, diagnostics);
  report_second_parents(kinematics, diagnostics);
  if (diagnostics.size() == findings) report_loops(kinematics.joints, diagnostics);
  const bool is_firmware_only = kinematics.links.empty() && kinematics.joints.empty();
  if (diagnostics.size() == findings && !is_firmware_only) check_with_urdfdom(robot, kinematics, diagnostics);
  return kinematics;
}

}  // namespace finemote::gen
