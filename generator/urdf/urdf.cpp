#include "generator/urdf/urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "generator/diagnostic/suggest.hpp"
#include "generator/urdf/urdfdom_check.hpp"

namespace finemote::gen {
namespace {

template <typename List>
auto find_by_name(const List& list, std::string_view name) -> decltype(&list.front()) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
  return found == list.end() ? nullptr : &*found;
}

const xml::Node* child_element(const xml::Node& node, std::string_view tag) {
  for (const xml::Node& child : node.children) {
    if (child.is_element(tag)) return &child;
  }
  return nullptr;
}

/// The attribute, or an error that it is missing.
const xml::Attribute* required(const xml::Node& node, std::string_view attribute, Diagnostics& diagnostics) {
  const xml::Attribute* found = node.attribute(attribute);
  if (found == nullptr) {
    diagnostics.error(code::attribute_missing, node.at, fmt::format("<{}> has no '{}'", node.name, attribute))
        .underline(node.name.size() + 1);
  }
  return found;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Numbers separated by white space; empty when one is malformed or not finite.
std::vector<double> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    if (text.empty()) return numbers;
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool stops = end == text.data() + text.size() || is_space(*end);
    if (error != std::errc() || !std::isfinite(value) || !stops) return {};
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

/// What a robot has in m, rad, kg or kg m^2 is between these; beyond them sums and products leave the range of a float.
constexpr double kLargest = 1e9;

bool check_range(const xml::Node& node, const xml::Attribute& found, const std::vector<double>& numbers, double least,
                 Diagnostics& diagnostics) {
  for (const double number : numbers) {
    if (number >= least && number <= kLargest) continue;
    diagnostics
        .error(code::urdf_range, found.value_at,
               fmt::format("'{}' of <{}> is out of range: {:g}", found.name, node.name, number))
        .underline(found.value.size())
        .hint(fmt::format("write {} from {:g} to {:g}", numbers.size() == 1 ? "a number" : "numbers", least, kLargest));
    return false;
  }
  return true;
}

std::optional<std::array<double, 3>> read_triple(const xml::Node& node, std::string_view attribute,
                                                 Diagnostics& diagnostics) {
  const xml::Attribute* found = node.attribute(attribute);
  if (found == nullptr) return {};
  const std::vector<double> numbers = parse_numbers(found->value);
  if (numbers.size() == 3) {
    if (!check_range(node, *found, numbers, -kLargest, diagnostics)) return {};
    return std::array<double, 3>{numbers[0], numbers[1], numbers[2]};
  }
  diagnostics
      .error(code::urdf_number, found->value_at,
             fmt::format("'{}' of <{}> has to be three numbers", attribute, node.name))
      .underline(found->value.size())
      .hint(fmt::format("for example {}=\"0.1 0 -0.25\"", attribute));
  return {};
}

std::optional<double> read_number(const xml::Node& node, std::string_view attribute, Diagnostics& diagnostics) {
  const xml::Attribute* found = node.attribute(attribute);
  if (found == nullptr) return {};
  const std::vector<double> numbers = parse_numbers(found->value);
  if (numbers.size() == 1) return numbers.front();
  diagnostics
      .error(code::urdf_number, found->value_at, fmt::format("'{}' of <{}> has to be a number", attribute, node.name))
      .underline(found->value.size());
  return {};
}

/// A number of an inertial.
double read_amount(const xml::Node& node, std::string_view attribute, double least, Diagnostics& diagnostics) {
  const auto number = read_number(node, attribute, diagnostics);
  const bool is_right = number && check_range(node, *node.attribute(attribute), {*number}, least, diagnostics);
  return is_right ? *number : 0;
}

Pose read_origin(const xml::Node& joint, Diagnostics& diagnostics) {
  Pose pose;
  const xml::Node* origin = child_element(joint, "origin");
  if (origin == nullptr) return pose;
  pose.xyz = read_triple(*origin, "xyz", diagnostics).value_or(pose.xyz);
  pose.rpy = read_triple(*origin, "rpy", diagnostics).value_or(pose.rpy);
  return pose;
}

void read_limit(const xml::Node& tag, Joint& joint, Diagnostics& diagnostics) {
  const xml::Node* limit = child_element(tag, "limit");
  if (limit == nullptr) return;
  joint.lower = read_number(*limit, "lower", diagnostics);
  joint.upper = read_number(*limit, "upper", diagnostics);
  joint.effort = read_number(*limit, "effort", diagnostics);
  joint.velocity = read_number(*limit, "velocity", diagnostics);
}

void read_dynamics(const xml::Node& tag, Joint& joint, Diagnostics& diagnostics) {
  const xml::Node* dynamics = child_element(tag, "dynamics");
  if (dynamics == nullptr) return;
  joint.damping = read_number(*dynamics, "damping", diagnostics);
  joint.friction = read_number(*dynamics, "friction", diagnostics);
}

std::optional<Inertial> read_inertial(const xml::Node& link, Diagnostics& diagnostics) {
  const xml::Node* tag = child_element(link, "inertial");
  if (tag == nullptr) return std::nullopt;
  Inertial inertial;
  inertial.origin = read_origin(*tag, diagnostics);
  if (const xml::Node* mass = child_element(*tag, "mass")) inertial.mass = read_amount(*mass, "value", 0, diagnostics);
  if (const xml::Node* inertia = child_element(*tag, "inertia")) {
    constexpr const char* kMoments[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
    for (std::size_t i = 0; i < inertial.inertia.size(); ++i)
      inertial.inertia[i] = read_amount(*inertia, kMoments[i], -kLargest, diagnostics);
  }
  return inertial;
}

void read_type(const xml::Node& tag, Joint& joint, Diagnostics& diagnostics) {
  const xml::Attribute* type = required(tag, "type", diagnostics);
  if (type == nullptr) return;
  joint.type = type->value;
  const std::vector<std::string> known{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
  if (std::find(known.begin(), known.end(), joint.type) != known.end()) return;
  diagnostics.error(code::joint_type, type->value_at, fmt::format("unknown joint type '{}'", joint.type))
      .underline(joint.type.size())
      .hint(did_you_mean(joint.type, known));
}

/// Reads `<parent link="..."/>` or `<child link="..."/>`; the link has to exist.
std::string read_end(const xml::Node& tag, std::string_view which, const std::vector<Link>& links,
                     Diagnostics& diagnostics) {
  const xml::Node* end = child_element(tag, which);
  if (end == nullptr) {
    diagnostics.error(code::attribute_missing, tag.at, fmt::format("<joint> has no <{}>", which))
        .underline(tag.name.size() + 1)
        .hint(fmt::format("add <{} link=\"...\"/>", which));
    return {};
  }
  const xml::Attribute* link = required(*end, "link", diagnostics);
  if (link == nullptr) return {};
  if (find_by_name(links, link->value) == nullptr) {
    std::vector<std::string> names;
    for (const Link& candidate : links) names.push_back(candidate.name);
    auto& finding =
        diagnostics.error(code::unknown_link, link->value_at, fmt::format("there is no link '{}'", link->value))
            .underline(link->value.size());
    if (!names.empty()) finding.hint(did_you_mean(link->value, names));
  }
  return link->value;
}

template <typename Entry>
void report_duplicates(const std::vector<Entry>& list, std::string_view what, Diagnostics& diagnostics) {
  std::map<std::string_view, const Entry*> seen;
  for (const Entry& entry : list) {
    const auto [first, fresh] = seen.emplace(entry.name, &entry);
    if (fresh) continue;
    diagnostics.error(code::duplicate_in_urdf, entry.at, fmt::format("there are two {}s '{}'", what, entry.name))
        .underline(what.size() + 1)
        .note("the first one is declared here", first->second->at);
  }
}

void report_second_parents(const std::vector<Joint>& joints, Diagnostics& diagnostics) {
  std::map<std::string_view, const Joint*> parent;
  for (const Joint& joint : joints) {
    if (joint.child_link.empty()) continue;
    const auto [first, fresh] = parent.emplace(joint.child_link, &joint);
    if (fresh) continue;
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

Joint read_joint(const xml::Node& tag, const std::vector<Link>& links, Diagnostics& diagnostics) {
  Joint joint;
  joint.at = tag.at;
  if (const xml::Attribute* name = required(tag, "name", diagnostics)) joint.name = name->value;
  read_type(tag, joint, diagnostics);
  joint.parent_link = read_end(tag, "parent", links, diagnostics);
  joint.child_link = read_end(tag, "child", links, diagnostics);
  joint.origin = read_origin(tag, diagnostics);
  if (const xml::Node* axis = child_element(tag, "axis"))
    joint.axis = read_triple(*axis, "xyz", diagnostics).value_or(joint.axis);
  read_limit(tag, joint, diagnostics);
  read_dynamics(tag, joint, diagnostics);
  if (const xml::Node* mimic = child_element(tag, "mimic")) {
    if (const xml::Attribute* leader = mimic->attribute("joint")) joint.mimic = leader->value;
  }
  return joint;
}

}  // namespace

const Link* Kinematics::link(std::string_view name) const { return find_by_name(links, name); }
const Joint* Kinematics::joint(std::string_view name) const { return find_by_name(joints, name); }

Kinematics read_urdf(const xml::Node& robot, Diagnostics& diagnostics) {
  const std::size_t findings = diagnostics.size();
  Kinematics kinematics;
  for (const xml::Node& child : robot.children) {
    if (!child.is_element("link")) continue;
    const xml::Attribute* name = required(child, "name", diagnostics);
    if (name != nullptr) kinematics.links.push_back({name->value, child.at, read_inertial(child, diagnostics)});
  }
  for (const xml::Node& child : robot.children) {
    // `<joint>` of a transmission stands deeper; one with only a name here belongs to another extension
    if (child.is_element("joint")) kinematics.joints.push_back(read_joint(child, kinematics.links, diagnostics));
  }
  report_duplicates(kinematics.links, "link", diagnostics);
  report_duplicates(kinematics.joints, "joint", diagnostics);
  report_second_parents(kinematics.joints, diagnostics);
  if (diagnostics.size() == findings) report_loops(kinematics.joints, diagnostics);
  const bool is_firmware_only = kinematics.links.empty() && kinematics.joints.empty();
  if (diagnostics.size() == findings && !is_firmware_only) check_with_urdfdom(robot, kinematics, diagnostics);
  return kinematics;
}

}  // namespace finemote::gen
