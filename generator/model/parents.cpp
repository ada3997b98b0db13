// Nesting and `parent=` to a forest, and the periods it hands down: FM3040 to FM3042, FM3004.
#include <fmt/format.h>

#include <algorithm>

#include "generator/model/attributes.hpp"
#include "generator/model/reading.hpp"

namespace finemote::gen {
namespace {

void resolve_parent(Reading& reading, DeviceId index) {
  const DeviceTag& tag = reading.tags.devices[index];
  Device& device = reading.robot.devices[index];
  const xml::Attribute* parent = tag.node->attribute("parent");
  device.parent = tag.nested_in;
  if (parent == nullptr) return;
  if (tag.nested_in) {
    const Device& around = reading.robot.devices[*tag.nested_in];
    at_value(reading.diagnostics, code::nested_and_parent, *parent,
             fmt::format("device '{}' is nested and has a 'parent'", device.name.text))
        .note(fmt::format("it is nested in device '{}'", around.name.text), around.at)
        .hint(around.name.text == parent->value ? fmt::format("remove parent=\"{}\"", parent->value)
                                                : fmt::format("remove parent=\"{}\", or move the device out of '{}'",
                                                              parent->value, around.name.text));
    return;
  }
  device.parent = reading.device_named(parent->value);
  if (device.parent) return;
  reading.devices[index].parent_is_wrong = true;
  std::vector<std::string> names = reading.device_names();
  names.erase(std::remove(names.begin(), names.end(), device.name.text), names.end());
  suggest(at_value(reading.diagnostics, code::unknown_parent, *parent,
                   fmt::format("there is no device '{}'", parent->value)),
          parent->value, names);
}

/// Devices from `start` up to where a device comes again; empty when a root is reached.
std::vector<DeviceId> cycle_through(const Robot& robot, DeviceId start) {
  std::vector<DeviceId> way{start};
  for (auto next = robot.devices[start].parent; next; next = robot.devices[*next].parent) {
    if (*next == start) return way;
    if (std::find(way.begin(), way.end(), *next) != way.end()) return {};  // a cycle further up, reported there
    way.push_back(*next);
  }
  return {};
}

void report_cycle(Reading& reading, const std::vector<DeviceId>& cycle) {
  const auto& devices = reading.robot.devices;
  std::string way;
  for (const DeviceId index : cycle) way += fmt::format("'{}' -> ", devices[index].name.text);
  way += fmt::format("'{}'", devices[cycle.front()].name.text);
  const auto with_attribute = std::find_if(cycle.begin(), cycle.end(), [&](DeviceId index) {
    return reading.device_tag(index).attribute("parent") != nullptr;
  });
  const DeviceId shown = with_attribute == cycle.end() ? cycle.front() : *with_attribute;
  const xml::Attribute* parent = reading.device_tag(shown).attribute("parent");
  const std::string message = cycle.size() == 1
                                  ? fmt::format("device '{}' is its own parent", devices[shown].name.text)
                                  : fmt::format("device '{}' is its own ancestor", devices[shown].name.text);
  Diagnostic& finding = parent != nullptr
                            ? at_value(reading.diagnostics, code::parent_cycle, *parent, message)
                            : at_tag(reading.diagnostics, code::parent_cycle, reading.device_tag(shown), message);
  if (cycle.size() > 1) finding.note("from child to parent: " + way);
  finding.hint("a root has no 'parent'");
}

/// Finds every cycle once; its devices, and those below, belong to no tree.
void find_cycles(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    if (reading.devices[i].in_cycle) continue;
    const std::vector<DeviceId> cycle = cycle_through(reading.robot, i);
    if (cycle.empty()) continue;
    for (const DeviceId member : cycle) reading.devices[member].in_cycle = true;
    report_cycle(reading, cycle);
  }
}

/// The ancestor, or the device itself, that says a period; none when no one does.
void inherit_period(Reading& reading, DeviceId index) {
  auto& devices = reading.robot.devices;
  Device& device = devices[index];
  if (device.period > Duration::zero() || reading.devices[index].period_is_wrong) return;
  DeviceId at = index;
  for (std::size_t steps = 0; steps <= devices.size(); ++steps) {
    const bool is_lost =
        reading.devices[at].period_is_wrong || reading.devices[at].in_cycle || reading.devices[at].parent_is_wrong;
    if (devices[at].period > Duration::zero()) break;
    if (is_lost) {
      reading.devices[index].period_is_wrong = true;
      return;
    }
    if (!devices[at].parent) {
      reading.devices[index].period_is_wrong = true;
      if (at == index) {
        at_tag(reading.diagnostics, code::period_missing, reading.device_tag(index),
               fmt::format("device '{}' has no 'period'", device.name.text))
            .note("it is a root: there is no parent to inherit one from")
            .hint("add for example period=\"10ms\"");
      }
      return;
    }
    at = *devices[at].parent;
  }
  device.period = devices[at].period;
  device.period_at = devices[at].period_at;
}

void inherit_periods(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) {
    if (!reading.devices[i].in_cycle) inherit_period(reading, i);
  }
}

}  // namespace

void resolve_parents(Reading& reading) {
  for (const DeviceId i : reading.robot.devices.ids()) resolve_parent(reading, i);
  find_cycles(reading);
  auto& devices = reading.robot.devices;
  for (const DeviceId i : devices.ids()) {
    if (devices[i].parent) devices[*devices[i].parent].children.push_back(i);
  }
  inherit_periods(reading);
}

}  // namespace finemote::gen
