#include "generator/cli/lint_options.hpp"

#include <fmt/format.h>

#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/lint/rules.hpp"

namespace finemote::gen {
namespace {

/// `FM3151` or `3151`: one of lint's own codes.
std::vector<Code> codes(const char* option, const std::vector<std::string>& words, Diagnostics& diagnostics) {
  std::vector<Code> list;
  std::vector<std::string> names;
  for (const Rule& rule : lint_rules_by_number()) names.push_back(code_name(rule.code));
  for (const std::string& word : words) {
    const auto code = parse_code(word);
    if (code && is_lint_code(*code)) {
      list.push_back(*code);
    } else {
      diagnostics.error(code::usage, {}, fmt::format("{} '{}' is not a lint code", option, word))
          .hint(did_you_mean(word, names));
    }
  }
  return list;
}

/// Load per bus of the robot, found by name: the model has the physical buses with a rate only.
Table<BusId, double> bus_loads(const Robot& robot, const timing::Timing& timing) {
  Table<BusId, double> loads(robot.buses.size(), 0.0);
  for (const timing::BusPlace i : timing.model.buses.ids()) {
    if (!timing.bus_loads.contains(i)) continue;
    for (const BusId bus : robot.buses.ids()) {
      if (robot.buses[bus].name.text == timing.model.buses[i].name) loads[bus] = timing.bus_loads[i].utilization;
    }
  }
  return loads;
}

/// By the time stamps of the data, which is what devices look at; where those have no bound, true ages.
Table<DeviceId, std::optional<CommandAge>> command_ages(const PlannedRobot& planned, const timing::Timing& timing) {
  Table<DeviceId, std::optional<CommandAge>> ages(planned.robot.devices.size());
  for (const bool is_stamped : {false, true}) {
    for (const timing::ChainResult& input : is_stamped ? timing.stamped_inputs : timing.inputs) {
      if (!input.age) continue;
      ages[planned.forest.order[input.to]] = {*input.age, planned.forest.order[input.from], is_stamped};
    }
  }
  return ages;
}

}  // namespace

std::optional<LintOptions> lint_options(const std::vector<std::string>& allow, const std::vector<std::string>& deny,
                                        const PlannedRobot& planned, const timing::Timing& timing,
                                        const Verdict& verdict, Diagnostics& diagnostics) {
  LintOptions options;
  options.allow = codes("--allow", allow, diagnostics);
  options.deny = codes("--deny", deny, diagnostics);
  options.bus_load = bus_loads(planned.robot, timing);
  options.overloads = verdict.overloads;
  options.command_ages = command_ages(planned, timing);
  if (diagnostics.has_errors()) return std::nullopt;
  return options;
}

}  // namespace finemote::gen
