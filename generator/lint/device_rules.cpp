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

bool divides_either_way(Duration one, Duration other) { return is_multiple(one, other) || is_multiple(other, one); }

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
void offer_periods(Duration own, Duration parent, Duration tick, Diagnostic& finding) {
  const std::int64_t times = std::max<std::int64_t>(1, own > parent ? floor_div(own, parent) : floor_div(parent, own));
  const auto offer = [&](Duration period) {
    finding.hint(fmt::format("for example period=\"{}\"", units::format_duration(period)));
  };
  if (own > parent) offer(parent * times);
  if (own < parent && is_multiple(parent, times * tick)) offer(floor_div(parent, times));
}

bool suits_neighbours(const Robot& robot, const Device& device, Duration period) {
  const auto suits = [&](DeviceId other) { return divides_either_way(period, robot.devices[other].period); };
  return (!device.parent || suits(*device.parent)) &&
         std::all_of(device.children.begin(), device.children.end(), suits);
}

/// The shortest period of whole ticks from `least` on that suits parent and children, if there is one nearby. Throws
/// Overflow.
Duration suitable_period(const Robot& robot, const Device& device, Duration least) {
  constexpr std::int64_t kTries = 1000;
  const Duration first = round_up(least, robot.tick);
  for (std::int64_t n = 0; n < kTries; ++n) {
    if (suits_neighbours(robot, device, first + n * robot.tick)) return first + n * robot.tick;
  }
  return first;
}

void report_command_age(const CheckedDevice& checked, const Param& param, Duration most, Findings& findings) {
  const CommandAge& age = *checked.command_age;
  const Device& source = checked.robot.devices[age.source];
  const auto rounded_up = [&](Duration step) {
    const bool fits = age.value <= Duration::max() - step;
    return units::format_duration(fits ? round_up(age.value, step) : age.value);
  };
  const std::string known = rounded_up(microseconds(1));
  const std::string how_old = age.is_stamped ? fmt::format("can look {} old by their time stamps", known)
                                             : fmt::format("can be {} old, and look older by any time", known);
  Diagnostic& finding = findings.add(
      checked.device, fmt::format("data behind the commands of device '{}' {}, and its '{}' is {}",
                                  checked.device.name.text, how_old, param.spec->name, units::format_duration(most)));
  finding.note("it goes to its safe output although nothing has failed")
      .note(fmt::format("the oldest of these data come from '{}'", source.name.text), source.at);
  finding.hint(age.is_stamped ? fmt::format("allow <param name=\"{}\">{}</param> or more, or make the data fresher",
                                            param.spec->name, rounded_up(milliseconds(1)))
                              : "make the data fresher, and their bus less busy");
}

}  // namespace

void find_late_sensors(const CheckedDevice& checked, Findings& findings) {
  const Device* first_actuator = nullptr;
  for (const DeviceId index : checked.device.children) {
    const Device& child = checked.robot.devices[index];
    if (first_actuator == nullptr && is_actuator(child)) first_actuator = &child;
    const bool delays = first_actuator != nullptr && is_sensor(child) && child.period == first_actuator->period;
    if (delays) report_order(*first_actuator, child, findings);
  }
}

void find_odd_period(const CheckedDevice& checked, Findings& findings) {
  const Device& child = checked.device;
  if (!child.parent) return;
  const Device& parent = checked.robot.devices[*child.parent];
  if (divides_either_way(child.period, parent.period)) return;
  Diagnostic& finding = findings.add(
      child.period_at,
      fmt::format("the period of device '{}' ({}) is neither a multiple nor a divisor of its parent's ({})",
                  child.name.text, units::format_duration(child.period), units::format_duration(parent.period)));
  finding.note("the age of what crosses between them then varies from job to job, and its worst case is long")
      .note(fmt::format("parent '{}' is declared here", parent.name.text), parent.at);
  offer_periods(child.period, parent.period, checked.robot.tick, finding);
}

void find_missing_wcet(const CheckedDevice& checked, Findings& findings) {
  const Device& device = checked.device;
  if (device.wcet.source != Wcet::Source::assumed) return;
  if (device.wcet.is_of_stale_file && !findings.is_denied()) return;  // FM4022 says so of all of them
  const std::string update = units::format_duration(device.wcet.update);
  const std::string handle = units::format_duration(device.wcet.handle);
  findings.add(device, fmt::format("device '{}' has no <wcet>", device.name.text))
      .note(
          fmt::format("update {} and handle {} are assumed; every bound that depends on them says so", update, handle))
      .hint("let finemote wcet compute bounds of all stages from the image, in a timing file beside the robot")
      .hint(fmt::format(
          "or add <wcet update=\"{}\" handle=\"{}\" source=\"budget\"/> if it never takes longer; finemote run "
          "prints the element with source=\"measured\"",
          update, handle));
}

std::string offered_period(const CheckedDevice& checked, Duration conversion) {
  try {
    const Duration period = suitable_period(checked.robot, checked.device, conversion);
    return fmt::format("write period=\"{}\" or longer, or ", units::format_duration(period));
  } catch (const Overflow&) {
    return {};
  }
}

void find_long_conversion(const CheckedDevice& checked, Findings& findings) {
  const Device& device = checked.device;
  const Duration conversion = conversion_time(device);
  if (conversion <= device.period) return;
  findings
      .add(device, fmt::format("a conversion of device '{}' takes {}, longer than its period of {}", device.name.text,
                               units::format_duration(conversion), units::format_duration(device.period)))
      .note("most of its updates will find no new sample")
      .hint(offered_period(checked, conversion) + "choose a shorter conversion");
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
    if (!param.spec->limits_command_age || most == nullptr || checked.command_age->value <= nanoseconds(*most))
      continue;
    report_command_age(checked, param, nanoseconds(*most), findings);
  }
}

}  // namespace finemote::gen
