// Children and `reads` to the roles of their parent and reader: FM3043 to FM3045, FM3051 to FM3054, FM3057.
#include <fmt/format.h>

#include <algorithm>

#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
bool satisfies(const DeviceType& child, const RoleSpec& role) {
  if (role.interface == "any") return true;
  return std::any_of(child.provides.begin(), child.provides.end(),
                     [&](const Interface& provided) { return provided.name == role.interface; });
}

bool is_descendant(const Robot& robot, DeviceId device, DeviceId of) {
  std::size_t steps = 0;
  for (auto at = std::optional<DeviceId>(device); at && steps <= robot.devices.size();
       at = robot.devices[*at].parent, ++steps) {
    if (*at == of) return true;
  }
  return false;
}

namespace {

std::vector<std::string> names_of(const std::vector<RoleSpec>& roles) {
  std::vector<std::string> names;
  for (const RoleSpec& role : roles) names.push_back(role.name);
  return names;
}

std::optional<std::size_t> role_named(const DeviceType& type, std::string_view name) {
  for (std::size_t i = 0; i < type.roles.size(); ++i) {
    if (type.roles[i].name == name) return i;
  }
  return {};
}

std::string provided_by(const DeviceType& type) {
  std::string text;
  for (const Interface& provided : type.provides) text += (text.empty() ? "'" : ", '") + provided.name + "'";
  return text.empty() ? "nothing" : text;
}

/// Which role would do, for the hint.
std::string fitting_roles(const DeviceType& parent, const DeviceType& child) {
  std::string text;
  for (const RoleSpec& role : parent.roles) {
    if (satisfies(child, role)) text += fmt::format("{}role=\"{}\"", text.empty() ? "" : " or ", role.name);
  }
  return text;
}

/// A role given by name has to exist and to take the child's type. `where` is how messages call the parent.
std::optional<std::size_t> named_role(Reading& reading, const xml::Attribute& attribute, const DeviceType& parent,
                                      const DeviceType* child, const std::string& where) {
  const auto role = role_named(parent, attribute.value);
  if (!role) {
    auto& finding = at_value(reading.diagnostics, code::unknown_role, attribute,
                             fmt::format("{} has no role '{}'", where, attribute.value));
    if (parent.roles.empty()) {
      finding.note(fmt::format("'{}' takes no children", parent.name));
    } else {
      suggest(finding, attribute.value, names_of(parent.roles));
    }
    return {};
  }
  if (child == nullptr || satisfies(*child, parent.roles[*role])) return role;
  auto& finding = at_value(reading.diagnostics, code::role_interface, attribute,
                           fmt::format("'{}' cannot take the role '{}' of {}", child->name, attribute.value, where));
  finding.note(fmt::format("the role needs '{}'; '{}' provides {}", parent.roles[*role].interface, child->name,
                           provided_by(*child)));
  const std::string fitting = fitting_roles(parent, *child);
  if (!fitting.empty()) finding.hint("write " + fitting);
  return {};
}

/// Without `role`, the only one the child's type satisfies.
std::optional<std::size_t> only_role(Reading& reading, DeviceId index, const DeviceType& parent,
                                     const DeviceType& child, const std::string& where) {
  std::vector<std::size_t> fitting;
  for (std::size_t i = 0; i < parent.roles.size(); ++i) {
    if (satisfies(child, parent.roles[i])) fitting.push_back(i);
  }
  if (fitting.size() == 1) return fitting.front();
  const Device& device = reading.robot.devices[index];
  const xml::Node& tag = reading.device_tag(index);
  if (fitting.empty()) {
    auto& finding = at_tag(reading.diagnostics, code::role_no_fit, tag,
                           fmt::format("{} has no role for device '{}'", where, device.name.text));
    finding.note(fmt::format("'{}' provides {}", child.name, provided_by(child)));
    if (parent.roles.empty()) finding.note(fmt::format("'{}' takes no children", parent.name));
    for (const RoleSpec& role : parent.roles)
      finding.note(fmt::format("role '{}' needs '{}'", role.name, role.interface));
    return {};
  }
  std::string choices;
  for (const std::size_t i : fitting)
    choices += fmt::format("{}role=\"{}\"", choices.empty() ? "" : " or ", parent.roles[i].name);
  at_tag(reading.diagnostics, code::role_ambiguous, tag,
         fmt::format("device '{}' could take more than one role of {}", device.name.text, where))
      .hint("add " + choices);
  return {};
}

void resolve_child(Reading& reading, DeviceId index) {
  Device& device = reading.robot.devices[index];
  Reading::DeviceState& state = reading.devices[index];
  const xml::Attribute* role = reading.device_tag(index).attribute("role");
  if (!device.parent) {
    if (role == nullptr || state.parent_is_wrong) return;
    at_value(reading.diagnostics, code::role_without_parent, *role,
             fmt::format("device '{}' has a role, but no parent", device.name.text))
        .hint("nest it in its parent, or add parent=\"...\"");
    return;
  }
  const Device& parent = reading.robot.devices[*device.parent];
  if (parent.type == nullptr) return;
  const std::string where = fmt::format("device '{}'", parent.name.text);
  if (role != nullptr) {
    device.role = named_role(reading, *role, *parent.type, device.type, where);
  } else if (device.type != nullptr) {
    device.role = only_role(reading, index, *parent.type, *device.type, where);
  }
  if (!device.role) reading.devices[*device.parent].is_incomplete = true;
}

/// <reads> of the reader itself, of a child (which reaches it by role), or of a device further down (which does not).
void report_own_subtree(Reading& reading, const xml::Attribute& name, DeviceId reader, DeviceId target) {
  const auto& devices = reading.robot.devices;
  const std::string& reads = devices[reader].name.text;
  const std::string& read = devices[target].name.text;
  const bool is_self = target == reader;
  const bool is_child = !is_self && devices[target].parent == reader;
  const std::string what = is_self ? "state" : is_child ? "child" : "descendant";
  auto& finding = at_value(reading.diagnostics, code::reads_own_subtree, name,
                           fmt::format("device '{}' reads its own {}", reads, what));
  if (is_self || is_child) {
    finding.note("children reach their parent by role; <reads> is for devices outside the subtree")
        .hint("remove the <reads>");
    return;
  }
  DeviceId child = target;
  while (devices[child].parent != reader) child = *devices[child].parent;
  finding
      .note("a device sees the states of its children only; states further down reach it through the child in between")
      .hint(fmt::format("let the type of '{}' copy what it reads of '{}' into its own State", devices[child].name.text,
                        read))
      .hint(fmt::format("or declare '{}' directly below '{}'", read, reads));
}

void read_reads(Reading& reading, DeviceId index, const xml::Node& tag) {
  Device& reader = reading.robot.devices[index];
  const xml::Attribute* name = tag.attribute("device");
  const xml::Attribute* role = tag.attribute("role");
  const auto target = name != nullptr ? reading.device_named(name->value) : std::nullopt;
  if (!target && name != nullptr) {
    suggest(
        at_value(reading.diagnostics, code::unknown_device, *name, fmt::format("there is no device '{}'", name->value)),
        name->value, reading.device_names());
  }
  const bool is_own = target && is_descendant(reading.robot, *target, index);
  if (is_own) report_own_subtree(reading, *name, index, *target);
  std::optional<std::size_t> found;
  if (reader.type != nullptr && role != nullptr) {
    const DeviceType* target_type = target ? reading.robot.devices[*target].type : nullptr;
    found = named_role(reading, *role, *reader.type, target_type, fmt::format("device '{}'", reader.name.text));
  }
  if (!target || !found || is_own) {
    reading.devices[index].is_incomplete = true;
    return;
  }
  reader.reads.push_back({*target, *found, tag.at});
}

void read_all_reads(Reading& reading, DeviceId index) {
  for (const xml::Node& child : reading.device_tag(index).children) {
    if (child.is_element("reads")) read_reads(reading, index, child);
  }
}

/// Looks for a way from a device back to itself over data that goes up: child to parent, and read device to reader.
class DataCycles {
 public:
  explicit DataCycles(Reading& reading)
      : reading_(reading), state_(reading.robot.devices.size(), State::fresh), edges_(reading.robot.devices.size()) {
    const auto& devices = reading.robot.devices;
    for (const DeviceId i : devices.ids()) {
      for (const DeviceId child : devices[i].children) edges_[i].push_back({child, nullptr});
      for (const Read& read : devices[i].reads) edges_[i].push_back({read.device, &read});
    }
  }
  void run() {
    for (const DeviceId i : edges_.ids()) {
      if (state_[i] == State::fresh && !reading_.devices[i].in_cycle) visit(i);
    }
  }

 private:
  enum class State { fresh, open, done };
  struct Edge {
    DeviceId to;
    const Read* read;  ///< null: a child
  };
  struct Step {
    DeviceId device;
    std::size_t next_edge = 0;
  };

  /// Depth first without recursion; a read that leads to an open device closes a cycle.
  void visit(DeviceId start) {
    std::vector<Step> way{{start}};
    state_[start] = State::open;
    while (!way.empty()) {
      Step& step = way.back();
      if (step.next_edge == edges_[step.device].size()) {
        state_[step.device] = State::done;
        way.pop_back();
        continue;
      }
      const Edge edge = edges_[step.device][step.next_edge++];
      if (state_[edge.to] == State::open) {
        report(way, edge);
      } else if (state_[edge.to] == State::fresh && !reading_.devices[edge.to].in_cycle) {
        state_[edge.to] = State::open;
        way.push_back({edge.to});
      }
    }
  }
  void report(const std::vector<Step>& way, const Edge& closing) {
    const auto& devices = reading_.robot.devices;
    const auto begin =
        std::find_if(way.begin(), way.end(), [&](const Step& step) { return step.device == closing.to; });
    const Read* shown = closing.read;
    std::string text;
    for (auto step = begin; step != way.end(); ++step) {
      text += fmt::format("'{}' <- ", devices[step->device].name.text);
      const Edge& taken = edges_[step->device][step->next_edge - 1];
      if (shown == nullptr) shown = taken.read;
    }
    text += fmt::format("'{}'", devices[closing.to].name.text);
    if (shown == nullptr) return;
    reading_.diagnostics.error(code::reads_cycle, shown->at, "this <reads> closes a cycle of data")
        .underline(6)
        .note("each takes data of the next: " + text)
        .hint("remove one of the <reads>");
  }

  Reading& reading_;
  Table<DeviceId, State> state_;
  Table<DeviceId, std::vector<Edge>> edges_;
};

}  // namespace

void resolve_roles(Reading& reading) {
  const auto ids = reading.robot.devices.ids();
  for (const DeviceId i : ids) {
    if (!reading.devices[i].in_cycle) resolve_child(reading, i);
  }
  for (const DeviceId i : ids) read_all_reads(reading, i);
  DataCycles(reading).run();
}

}  // namespace finemote::gen
