// Names of the robot, its buses, expanders and devices: FM3046 to FM3049.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/descriptor/cpp_words.hpp"
#include "generator/diagnostic/printable.hpp"
#include "generator/model/attributes.hpp"
#include "generator/model/names.hpp"
#include "generator/model/reading.hpp"
#include "generator/model/taken_names.hpp"

namespace finemote::gen {
namespace {

/// One name and what has it.
struct Named {
  const Name* name;
  const xml::Node* tag;
  std::string what;  ///< "bus 'imu'"
};

/// Finds clashes among names that share a place.
class NameTable {
 public:
  explicit NameTable(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Adds the name, or reports what has it already.
  bool add(const Named& entry) {
    const auto [first, is_fresh] = seen_.emplace(fold_case(entry.name->cpp), entry);
    if (!is_fresh) report(entry, first->second);
    return is_fresh;
  }
  /// Reports what has the name already; does not add it.
  void compare(const Named& entry) {
    const auto found = seen_.find(fold_case(entry.name->cpp));
    if (found != seen_.end()) report(entry, found->second);
  }

 private:
  void report(const Named& entry, const Named& first) {
    const xml::Attribute* attribute = entry.tag->attribute("name");
    if (entry.name->text == first.name->text) {
      at_value(diagnostics_, code::duplicate_name, *attribute,
               fmt::format("the name '{}' is used twice", entry.name->text))
          .note(fmt::format("{} has it already", first.what), first.tag->at)
          .hint("rename one of them");
      return;
    }
    auto& finding = at_value(diagnostics_, code::name_clash, *attribute,
                             fmt::format("'{}' and '{}' are the same name in C++", entry.name->text, first.name->text));
    const bool same = entry.name->cpp == first.name->cpp;
    finding.note(same ? fmt::format("both become '{}'", entry.name->cpp)
                      : fmt::format("'{}' and '{}' differ by letter case only", entry.name->cpp, first.name->cpp));
    finding.note(fmt::format("{} is declared here", first.what), first.tag->at).hint("rename one of them");
  }

  Diagnostics& diagnostics_;
  std::map<std::string, Named> seen_;
};

/// A name that is possible and still tells what was meant: `x__y` -> `x_y`, `_Imu` -> `Imu`, `class` -> `class_1`.
std::string possible_name(const std::string& cpp) {
  std::string name;
  for (const char c : cpp) {
    if (c != '_' || (!name.empty() && name.back() != '_')) name += c;
  }
  if (name.empty()) return "part_1";
  return invalid_name(name) ? name + (name.back() == '_' ? "1" : "_1") : name;
}

/// A name near to one that is taken, and not taken: `slots` -> `slots_1`, `finemote_imu` -> `my_finemote_imu`.
std::string free_name(const std::string& cpp, NameScope scope) {
  const std::string behind = possible_name(cpp + "_1");
  return reserved_name(behind, scope) ? possible_name("my_" + cpp) : behind;
}

/// Generated files quote names in comments, where a line break would end the comment.
bool has_control_character(const std::string& text) {
  return printable(text) != text || text.find('\t') != std::string::npos;
}

/// A name that reads like another one, and that no operand of a requirement or of --chain can repeat.
bool is_padded(const std::string& text) { return !trim(text).empty() && trim(text).size() != text.size(); }

/// Whether the name can be used at all.
bool check_one(Diagnostics& diagnostics, const Named& entry, NameScope scope) {
  const xml::Attribute* attribute = entry.tag->attribute("name");
  if (attribute == nullptr) return false;
  const std::string& cpp = entry.name->cpp;
  const std::string becomes = cpp == entry.name->text ? "it" : fmt::format("its C++ name '{}'", cpp);
  if (has_control_character(entry.name->text)) {
    at_value(diagnostics, code::name_invalid, *attribute, "a name cannot contain a control character")
        .note(
            "a line break or tab written as a character reference, such as &#10;, is one; so is what turns the "
            "direction "
            "of writing")
        .hint(fmt::format("write for example name=\"{}\"", possible_name(cpp)));
    return false;
  }
  const bool is_referenced = scope == NameScope::in_robot || scope == NameScope::in_tree;
  if (is_referenced && is_padded(entry.name->text)) {
    at_value(diagnostics, code::name_invalid, *attribute, fmt::format("'{}' cannot be a name", entry.name->text))
        .note("it begins or ends with a blank")
        .hint(fmt::format("write name=\"{}\"", trim(entry.name->text)));
    return false;
  }
  if (const auto reason = invalid_name(cpp)) {
    at_value(diagnostics, code::name_invalid, *attribute, fmt::format("'{}' cannot be a name", entry.name->text))
        .note(fmt::format("{} {}", becomes, *reason))
        .hint(fmt::format("write for example name=\"{}\"", possible_name(cpp)));
    return false;
  }
  if (const auto reason = reserved_name(cpp, scope)) {
    at_value(diagnostics, code::name_reserved, *attribute, fmt::format("the name '{}' is taken", entry.name->text))
        .note(fmt::format("{} {}", becomes, *reason))
        .hint(fmt::format("write for example name=\"{}\"", free_name(cpp, scope)));
    return false;
  }
  return true;
}

void report_taken(Diagnostics& diagnostics, const Named& entry, std::string why, const std::string& instead) {
  at_value(diagnostics, code::name_reserved, *entry.tag->attribute("name"),
           fmt::format("the name '{}' is taken", entry.name->text))
      .note(std::move(why))
      .hint(fmt::format("write for example name=\"{}\"", instead));
}

/// A name in the robot's namespace, where things of the user's types can stand as well.
bool check_in_robot(Diagnostics& diagnostics, const Named& entry, const TakenNames& taken) {
  if (!check_one(diagnostics, entry, NameScope::in_robot)) return false;
  const std::string owner = taken.in_robot(entry.name->cpp);
  if (owner.empty()) return true;
  report_taken(diagnostics, entry, fmt::format("in the namespace of the robot it is {}", owner),
               free_name(entry.name->cpp, NameScope::in_robot));
  return false;
}

/// A name beside those of buses, which `utilization=` can name as well.
bool check_bus_name(Diagnostics& diagnostics, const Named& entry, const TakenNames& taken) {
  if (!check_in_robot(diagnostics, entry, taken)) return false;
  if (entry.name->text != "cpu") return true;
  report_taken(diagnostics, entry, "<require utilization=\"cpu\"> means the processor", "cpu_bus");
  return false;
}

/// `rov.thrusters` as a device's name, where 'rov' has the role 'thrusters': in operands it means the children.
bool check_role_operand(const Reading& reading, const Named& entry) {
  const std::string& text = entry.name->text;
  const std::size_t dot = text.rfind('.');
  const auto owner = dot == text.npos ? std::nullopt : reading.device_named(text.substr(0, dot));
  if (!owner || reading.robot.devices[*owner].type == nullptr) return true;
  const auto& roles = reading.robot.devices[*owner].type->roles;
  const std::string role = text.substr(dot + 1);
  if (std::none_of(roles.begin(), roles.end(), [&](const RoleSpec& spec) { return spec.name == role; })) return true;
  report_taken(
      reading.diagnostics, entry,
      fmt::format("in a requirement it means the children of '{}' in the role '{}'", text.substr(0, dot), role),
      possible_name(entry.name->cpp));
  return false;
}

std::string described(const char* what, const Name& name) { return fmt::format("{} '{}'", what, name.text); }

}  // namespace

void check_names(Reading& reading) {
  Diagnostics& diagnostics = reading.diagnostics;
  const Robot& robot = reading.robot;
  const Named whole{&robot.name, &reading.root, "robot"};
  const TakenNames taken(robot);
  const bool is_named =
      check_one(diagnostics, whole, NameScope::robot) && check_one(diagnostics, whole, NameScope::file);
  if (is_named && !taken.robot_taken().empty()) {
    report_taken(diagnostics, whole, fmt::format("generated code cannot stand beside {}", taken.robot_taken()),
                 free_name(robot.name.cpp, NameScope::robot));
  }

  NameTable buses(diagnostics);    // what `bus=` can name, and names beside the tree namespaces
  NameTable devices(diagnostics);  // what `parent=` and `device=` can name
  NameTable slots(diagnostics);    // transfer slots of expanders stand beside those of devices
  for (const BusId i : robot.buses.ids()) {
    const Named entry{&robot.buses[i].name, reading.tags.buses[i], described("bus", robot.buses[i].name)};
    if (check_bus_name(diagnostics, entry, taken)) buses.add(entry);
  }
  for (const ExpanderId i : robot.expanders.ids()) {
    const Expander& expander = robot.expanders[i];
    const Named entry{&expander.name, reading.tags.expanders[i], described("expander", expander.name)};
    if (!check_bus_name(diagnostics, entry, taken)) continue;
    buses.add(entry);
    slots.add(entry);
    std::size_t channel = 0;
    for (const xml::Node& child : reading.tags.expanders[i]->children) {
      if (!child.is_element("channel") || channel >= expander.channels.size()) continue;
      const Name& name = expander.channels[channel++].name;
      const Named inner{&name, &child, described("channel", name)};
      if (check_bus_name(diagnostics, inner, taken)) buses.add(inner);
    }
  }
  for (const DeviceId i : robot.devices.ids()) {
    const Named entry{&robot.devices[i].name, &reading.device_tag(i), described("device", robot.devices[i].name)};
    if (!check_one(diagnostics, entry, NameScope::in_tree) || !check_role_operand(reading, entry)) continue;
    const bool is_fresh = devices.add(entry);
    const bool is_root = !reading.tags.devices[i].nested_in && reading.device_tag(i).attribute("parent") == nullptr;
    if (!is_fresh) continue;
    if (!is_root) {
      slots.compare(entry);
    } else if (check_in_robot(diagnostics, entry, taken) && check_one(diagnostics, entry, NameScope::tree_file)) {
      buses.add(entry);  // its tree's namespace stands beside them
    }
  }
}

}  // namespace finemote::gen
