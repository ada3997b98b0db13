#include "generator/lint/device_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/model/conversion.hpp"
#include "generator/model/device_frames.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

bool is_actuator(const Device& device) { return device.type->actuator && device.children.empty(); }

bool is_sensor(const Device& device) {
  return device.children.empty() && !device.type->has_command() && !device.type->actuator;
}

bool divides_either_way(std::int64_t one, std::int64_t other) { return one % other == 0 || other % one == 0; }

void report_order(const Device& actuator, const Device& sensor, Findings& findings) {
  Diagnostic& finding = findings.add(
      sensor, fmt::format("sensor '{}' is declared after actuator '{}'", sensor.name.text, actuator.name.text));
  finding
      .note(
          "handles run in the reverse order of declaration, so the actuator is commanded only after the sensor's "
          "handle()")
      .note(fmt::format("actuator '{}' is declared here", actuator.name.text), actuator.at)
      .hint(fmt::format("declare '{}' before '{}'", sensor.name.text, actuator.name.text));
  findings.fix(finding, sensor.name.text, move_before(sensor.at, actuator.at));
}

/// The periods next to the child's that suit its parent's.
void offer_periods(std::int64_t own, std::int64_t parent, std::int64_t tick, Diagnostic& finding) {
  const std::int64_t times = std::max<std::int64_t>(1, own > parent ? own / parent : parent / own);
  const auto offer = [&](std::int64_t period) {
    finding.hint(fmt::format("for example period=\"{}\"", units::format_duration(period)));
  };
  if (own > parent) offer(parent * times);
  if (own < parent && parent % times == 0 && parent / times % tick == 0) offer(parent / times);
}

bool suits_neighbours(const Robot& robot, const Device& device, std::int64_t period) {
  const auto suits = [&](DeviceId other) { return divides_either_way(period, robot.devices[other].period_ns); };
  return (!device.parent || suits(*device.parent)) &&
         std::all_of(device.children.begin(), device.children.end(), suits);
}

/// The shortest period of whole ticks from `least` on that suits parent and children, if there is one nearby.
std::int64_t suitable_period(const Robot& robot, const Device& device, std::int64_t least) {
  constexpr std::int64_t kTries = 1000;
  const std::int64_t first = (least + robot.tick_ns - 1) / robot.tick_ns * robot.tick_ns;
  for (std::int64_t n = 0; n < kTries; ++n) {
    if (suits_neighbours(robot, device, first + n * robot.tick_ns)) return first + n * robot.tick_ns;
  }
  return first;
}

void report_command_age(const CheckedDevice& checked, const Param& param, std::int64_t most, Findings& findings) {
  const CommandAge& age = *checked.command_age;
  const Device& source = checked.robot.devices[age.source];
  const auto rounded_up = [&](std::int64_t step) { return units::format_duration((age.ns + step - 1) / step * step); };
  findings
      .add(checked.device,
           fmt::format("data behind the commands of device '{}' can be {} old, and its '{}' is {}",
                       checked.device.name.text, rounded_up(1'000), param.spec->name, units::format_duration(most)))
      .note("it goes to its safe output although nothing has failed")
      .note(fmt::format("the oldest of these data come from '{}'", source.name.text), source.at)
      .hint(fmt::format("allow <param name=\"{}\">{}</param> or more, or make the data fresher", param.spec->name,
                        rounded_up(1'000'000)));
}

}  // namespace

void find_late_sensors(const CheckedDevice& checked, Findings& findings) {
  const Device* first_actuator = nullptr;
  for (const DeviceId index : checked.device.children) {
    const Device& child = checked.robot.devices[index];
    if (first_actuator == nullptr && is_actuator(child)) first_actuator = &child;
    const bool delays = first_actuator != nullptr && is_sensor(child) && child.period_ns == first_actuator->period_ns;
    if (delays) report_order(*first_actuator, child, findings);
  }
}

void find_odd_period(const CheckedDevice& checked, Findings& findings) {
  const Device& child = checked.device;
  if (!child.parent) return;
  const Device& parent = checked.robot.devices[*child.parent];
  if (divides_either_way(child.period_ns, parent.period_ns)) return;
  Diagnostic& finding = findings.add(
      child.period_at,
      fmt::format("the period of device '{}' ({}) is neither a multiple nor a divisor of its parent's ({})",
                  child.name.text, units::format_duration(child.period_ns), units::format_duration(parent.period_ns)));
  finding.note("the age of what crosses between them then varies from job to job, and its worst case is long")
      .note(fmt::format("parent '{}' is declared here", parent.name.text), parent.at);
  offer_periods(child.period_ns, parent.period_ns, checked.robot.tick_ns, finding);
}

void find_missing_wcet(const CheckedDevice& checked, Findings& findings) {
  const Device& device = checked.device;
  if (device.wcet.source != Wcet::Source::assumed) return;
  const std::string update = units::format_duration(device.wcet.update_ns);
  const std::string handle = units::format_duration(device.wcet.handle_ns);
  findings.add(device, fmt::format("device '{}' has no <wcet>", device.name.text))
      .note(
          fmt::format("update {} and handle {} are assumed; every bound that depends on them says so", update, handle))
      .hint(fmt::format("add <wcet update=\"{}\" handle=\"{}\" source=\"budget\"/> if it keeps to that; finemote run "
                        "prints the element with source=\"measured\"",
                        update, handle));
}

void find_long_conversion(const CheckedDevice& checked, Findings& findings) {
  const Device& device = checked.device;
  const std::int64_t conversion = conversion_ns(device);
  if (conversion <= device.period_ns) return;
  findings
      .add(device, fmt::format("a conversion of device '{}' takes {}, longer than its period of {}", device.name.text,
                               units::format_duration(conversion), units::format_duration(device.period_ns)))
      .note("most of its updates will find no new sample")
      .hint(fmt::format("write period=\"{}\" or longer, or choose a shorter conversion",
                        units::format_duration(suitable_period(checked.robot, device, conversion))));
}

void find_replaced_params(const CheckedDevice& checked, Findings& findings) {
  const Device& device = checked.device;
  for (const GeometrySpec& geometry : device.type->geometry) {
    if (role_joints(checked.robot, device, geometry).empty()) continue;
    for (const Param& param : device.params) {
      const auto& replaced = geometry.replaces;
      if (!param.given || std::find(replaced.begin(), replaced.end(), param.spec->name) == replaced.end()) continue;
      findings.add(device, fmt::format("param '{}' of device '{}' has no effect", param.spec->name, device.name.text))
          .note(fmt::format("it is computed from the joints of the {}", geometry.role))
          .hint("remove it");
    }
  }
}

void find_old_commands(const CheckedDevice& checked, Findings& findings) {
  if (!checked.command_age) return;
  for (const Param& param : checked.device.params) {
    const auto* most = std::get_if<std::int64_t>(&param.value);
    if (!param.spec->limits_command_age || most == nullptr || checked.command_age->ns <= *most) continue;
    report_command_age(checked, param, *most, findings);
  }
}

}  // namespace finemote::gen
