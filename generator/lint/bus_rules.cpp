#include "generator/lint/bus_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace finemote::gen {
namespace {

bool is_used(const Robot& robot, BusId bus) {
  const auto is_on_bus = [&](const auto& part) { return part.segment && robot.segments[*part.segment].bus == bus; };
  return std::any_of(robot.expanders.begin(), robot.expanders.end(),
                     [&](const Expander& expander) { return robot.segments[expander.segment].bus == bus; }) ||
         std::any_of(robot.devices.begin(), robot.devices.end(), [&](const Device& device) {
           return is_on_bus(device) || std::any_of(device.uses.begin(), device.uses.end(), is_on_bus);
         });
}

bool is_required(const Robot& robot, BusId bus) {
  return std::any_of(robot.requirements.begin(), robot.requirements.end(),
                     [&](const Requirement& requirement) { return requirement.bus == bus; });
}

Diagnostic& add(Findings& findings, const Bus& bus, std::string message) {
  return findings.add(bus.at, std::move(message)).underline(std::string_view("<bus").size());
}

}  // namespace

void find_unused_bus(const CheckedBus& checked, Findings& findings) {
  const Bus& bus = checked.bus();
  if (is_used(checked.robot, checked.id)) return;
  Diagnostic& finding = add(findings, bus, fmt::format("bus '{}' is unused", bus.name.text));
  finding.hint(fmt::format("remove it{}: it costs start-up code and interrupts",
                           is_required(checked.robot, checked.id) ? ", and the <require> that names it" : ""));
  findings.fix(finding, bus.name.text, remove_element(bus.at));
}

void find_busy_bus(const CheckedBus& checked, Findings& findings) {
  if (!checked.is_busy() || checked.overload != nullptr) return;
  const Bus& bus = checked.bus();
  add(findings, bus, fmt::format("bus '{}' is busy for {:.0f} % of the time", bus.name.text, checked.load * 100))
      .note(fmt::format("above {:.0f} % there is little room for repeats after a disturbance", checked.most_load * 100))
      .hint("lengthen periods on it, raise its rate, or move devices to another bus");
}

void find_overloaded_bus(const CheckedBus& checked, Findings& findings) {
  if (checked.is_busy() && checked.overload != nullptr) findings.add(*checked.overload);
}

}  // namespace finemote::gen
