#include "generator/lint/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/geometry/role_joints.hpp"
#include "generator/lint/codes.hpp"
#include "generator/lint/hardware.hpp"
#include "generator/lint/joints.hpp"
#include "generator/lint/mechanics.hpp"
#include "generator/model/conversion.hpp"
#include "generator/units/units.hpp"

namespace finemote::gen {
namespace {

bool contains(const std::vector<Code>& codes, Code code) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

class Linter {
 public:
  Linter(const Robot& robot, const LintOptions& options, Diagnostics& diagnostics)
      : robot_(robot), options_(options), diagnostics_(diagnostics) {}

  std::vector<Fix> run() {
    for (std::size_t i = 0; i < robot_.buses.size(); ++i) check_bus(i);
    for (std::size_t i = 0; i < robot_.devices.size(); ++i) {
      check_order(robot_.devices[i]);
      check_periods(robot_.devices[i]);
      check_wcet(robot_.devices[i]);
      check_conversion(robot_.devices[i]);
      check_replaced(robot_.devices[i]);
      check_command_age(i);
      for (const Diagnostic& finding : mechanics_findings(robot_, robot_.devices[i])) add(finding);
      for (const Diagnostic& finding : joint_findings(robot_, robot_.devices[i])) add(finding);
    }
    for (const Diagnostic& finding : hardware_findings(robot_)) add(finding);
    return std::move(fixes_);
  }

 private:
  /// A place to note and hint at; null when the code is allowed.
  Diagnostic* report(LintCode lint, Position at, std::string message) {
    if (contains(options_.allow, lint.code)) return nullptr;
    Diagnostic& finding = contains(options_.deny, lint.code) ? diagnostics_.error(lint.code, at, std::move(message))
                                                             : diagnostics_.warning(lint.code, at, std::move(message));
    return &finding;
  }

  /// A finding made elsewhere, unless its code is allowed.
  void add(Diagnostic finding) {
    if (contains(options_.allow, finding.code)) return;
    if (contains(options_.deny, finding.code)) finding.severity = Severity::error;
    diagnostics_.add(finding);
  }

  [[nodiscard]] bool is_used(std::size_t bus) const {
    for (const Expander& expander : robot_.expanders) {
      if (robot_.segments[expander.segment].bus == bus) return true;
    }
    for (const Device& device : robot_.devices) {
      if (device.segment && robot_.segments[*device.segment].bus == bus) return true;
      for (const Use& use : device.uses) {
        if (use.segment && robot_.segments[*use.segment].bus == bus) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool is_required(std::size_t bus) const {
    return std::any_of(robot_.requirements.begin(), robot_.requirements.end(),
                       [&](const Requirement& requirement) { return requirement.bus == bus; });
  }
  void check_bus(std::size_t index) {
    const Bus& bus = robot_.buses[index];
    if (!is_used(index)) {
      Diagnostic* finding = report(code::lint_unused_bus, bus.at, fmt::format("bus '{}' is unused", bus.name.text));
      if (finding == nullptr) return;
      finding->underline(4).hint(fmt::format("remove it{}: it costs start-up code and interrupts",
                                             is_required(index) ? ", and the <require> that names it" : ""));
      fixes_.push_back({finding->code, finding->message, bus.name.text, remove_element(bus.at)});
      return;
    }
    if (index >= options_.bus_load.size() || options_.bus_load[index] <= options_.most_bus_load) return;
    for (const Diagnostic& overload : options_.overloads) {
      if (overload.at.line == bus.at.line && overload.at.column == bus.at.column) return report_overload(overload);
    }
    Diagnostic* finding =
        report(code::lint_bus_load, bus.at,
               fmt::format("bus '{}' is busy for {:.0f} % of the time", bus.name.text, options_.bus_load[index] * 100));
    if (finding == nullptr) return;
    finding->underline(4)
        .note(fmt::format("above {:.0f} % there is little room for repeats after a disturbance",
                          options_.most_bus_load * 100))
        .hint("lengthen periods on it, raise its rate, or move devices to another bus");
  }

  void report_overload(Diagnostic finding) {
    if (contains(options_.allow, finding.code)) return;
    const bool is_denied = contains(options_.deny, finding.code) || contains(options_.deny, code::lint_bus_load);
    if (is_denied) finding.severity = Severity::error;
    diagnostics_.add(finding);
  }

  [[nodiscard]] static bool is_actuator(const Device& device) {
    return device.type->actuator && device.children.empty();
  }
  [[nodiscard]] static bool is_sensor(const Device& device) {
    return device.children.empty() && !device.type->has_command() && !device.type->actuator;
  }

  /// Handles run backwards: what is declared last is commanded first. Leaves that are no actuators belong before them.
  void check_order(const Device& parent) {
    const Device* first_actuator = nullptr;
    for (const std::size_t index : parent.children) {
      const Device& child = robot_.devices[index];
      if (first_actuator == nullptr && is_actuator(child)) first_actuator = &child;
      const bool delays = first_actuator != nullptr && is_sensor(child) && child.period_ns == first_actuator->period_ns;
      if (delays) report_order(*first_actuator, child);
    }
  }
  void report_order(const Device& actuator, const Device& sensor) {
    Diagnostic* finding =
        report(code::lint_order, sensor.at,
               fmt::format("sensor '{}' is declared after actuator '{}'", sensor.name.text, actuator.name.text));
    if (finding == nullptr) return;
    finding->underline(7)
        .note(
            "handles run in the reverse order of declaration, so the actuator is commanded only after the sensor's "
            "handle()")
        .note(fmt::format("actuator '{}' is declared here", actuator.name.text), actuator.at)
        .hint(fmt::format("declare '{}' before '{}'", sensor.name.text, actuator.name.text));
    fixes_.push_back({finding->code, finding->message, sensor.name.text, move_before(sensor.at, actuator.at)});
  }

  void check_periods(const Device& child) {
    if (!child.parent) return;
    const Device& parent = robot_.devices[*child.parent];
    if (child.period_ns % parent.period_ns == 0 || parent.period_ns % child.period_ns == 0) return;
    const std::string own = units::format_duration(child.period_ns);
    const std::string other = units::format_duration(parent.period_ns);
    Diagnostic* finding =
        report(code::lint_period_ratio, child.period_at,
               fmt::format("the period of device '{}' ({}) is neither a multiple nor a divisor of its parent's ({})",
                           child.name.text, own, other));
    if (finding == nullptr) return;
    finding->note("the age of what crosses between them then varies from job to job, and its worst case is long")
        .note(fmt::format("parent '{}' is declared here", parent.name.text), parent.at);
    const std::int64_t times =
        std::max<std::int64_t>(1, child.period_ns > parent.period_ns ? child.period_ns / parent.period_ns
                                                                     : parent.period_ns / child.period_ns);
    const bool divides = child.period_ns < parent.period_ns && parent.period_ns % times == 0 &&
                         parent.period_ns / times % robot_.tick_ns == 0;
    if (child.period_ns > parent.period_ns)
      finding->hint(fmt::format("for example period=\"{}\"", units::format_duration(parent.period_ns * times)));
    if (divides)
      finding->hint(fmt::format("for example period=\"{}\"", units::format_duration(parent.period_ns / times)));
  }

  void check_wcet(const Device& device) {
    if (device.wcet.source != Wcet::Source::assumed) return;
    const std::string update = units::format_duration(device.wcet.update_ns);
    const std::string handle = units::format_duration(device.wcet.handle_ns);
    Diagnostic* finding =
        report(code::lint_no_wcet, device.at, fmt::format("device '{}' has no <wcet>", device.name.text));
    if (finding == nullptr) return;
    finding->underline(7)
        .note(fmt::format("update {} and handle {} are assumed; every bound that depends on them says so", update,
                          handle))
        .hint(fmt::format(
            "add <wcet update=\"{}\" handle=\"{}\" source=\"budget\"/> if it keeps to that; finemote run prints "
            "the element with source=\"measured\"",
            update, handle));
  }

  [[nodiscard]] bool suits_neighbours(const Device& device, std::int64_t period) const {
    const auto suits = [&](std::size_t other) {
      const std::int64_t theirs = robot_.devices[other].period_ns;
      return period % theirs == 0 || theirs % period == 0;
    };
    return (!device.parent || suits(*device.parent)) &&
           std::all_of(device.children.begin(), device.children.end(), suits);
  }
  /// The shortest period of whole ticks from `least` on that suits parent and children, if there is one nearby.
  [[nodiscard]] std::int64_t suitable_period(const Device& device, std::int64_t least) const {
    constexpr std::int64_t kTries = 1000;
    const std::int64_t first = (least + robot_.tick_ns - 1) / robot_.tick_ns * robot_.tick_ns;
    for (std::int64_t n = 0; n < kTries; ++n) {
      if (suits_neighbours(device, first + n * robot_.tick_ns)) return first + n * robot_.tick_ns;
    }
    return first;
  }
  void check_conversion(const Device& device) {
    const std::int64_t conversion = conversion_ns(device);
    if (conversion <= device.period_ns) return;
    Diagnostic* finding =
        report(code::lint_conversion, device.at,
               fmt::format("a conversion of device '{}' takes {}, longer than its period of {}", device.name.text,
                           units::format_duration(conversion), units::format_duration(device.period_ns)));
    if (finding == nullptr) return;
    finding->underline(7)
        .note("most of its updates will find no new sample")
        .hint(fmt::format("write period=\"{}\" or longer, or choose a shorter conversion",
                          units::format_duration(suitable_period(device, conversion))));
  }

  void check_replaced(const Device& device) {
    for (const GeometrySpec& geometry : device.type->geometry) {
      if (role_joints(robot_, device, geometry).empty()) continue;
      for (const Param& param : device.params) {
        const auto& replaced = geometry.replaces;
        if (!param.given || std::find(replaced.begin(), replaced.end(), param.spec->name) == replaced.end()) continue;
        Diagnostic* finding =
            report(code::lint_param_replaced, device.at,
                   fmt::format("param '{}' of device '{}' has no effect", param.spec->name, device.name.text));
        if (finding == nullptr) continue;
        finding->underline(7)
            .note(fmt::format("it is computed from the joints of the {}", geometry.role))
            .hint("remove it");
      }
    }
  }

  /// A limit that data exceed in regular operation sends the device to its safe output time and again.
  void check_command_age(std::size_t index) {
    if (index >= options_.command_ages.size() || !options_.command_ages[index]) return;
    const Device& device = robot_.devices[index];
    const CommandAge& age = *options_.command_ages[index];
    for (const Param& param : device.params) {
      const auto* most = std::get_if<std::int64_t>(&param.value);
      if (!param.spec->limits_command_age || most == nullptr || age.ns <= *most) continue;
      report_command_age(device, param, *most, age);
    }
  }
  void report_command_age(const Device& device, const Param& param, std::int64_t most, const CommandAge& age) {
    const auto rounded_up = [&](std::int64_t step) {
      return units::format_duration((age.ns + step - 1) / step * step);
    };
    Diagnostic* finding =
        report(code::lint_command_age, device.at,
               fmt::format("data behind the commands of device '{}' can be {} old, and its '{}' is {}",
                           device.name.text, rounded_up(1'000), param.spec->name, units::format_duration(most)));
    if (finding == nullptr) return;
    finding->underline(7)
        .note("it goes to its safe output although nothing has failed")
        .note(fmt::format("the oldest of these data come from '{}'", robot_.devices[age.source].name.text),
              robot_.devices[age.source].at)
        .hint(fmt::format("allow <param name=\"{}\">{}</param> or more, or make the data fresher", param.spec->name,
                          rounded_up(1'000'000)));
  }

  const Robot& robot_;
  const LintOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<Fix> fixes_;
};

}  // namespace

std::vector<Fix> lint(const Robot& robot, const LintOptions& options, Diagnostics& diagnostics) {
  return Linter(robot, options, diagnostics).run();
}

}  // namespace finemote::gen
