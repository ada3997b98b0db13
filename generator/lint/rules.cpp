#include "generator/lint/rules.hpp"

#include <algorithm>

#include "generator/diagnostic/code_hardware.hpp"
#include "generator/diagnostic/code_mechanics.hpp"
#include "generator/lint/bus_rules.hpp"
#include "generator/lint/command_rules.hpp"
#include "generator/lint/device_rules.hpp"
#include "generator/lint/hardware_rules.hpp"
#include "generator/lint/joint_rules.hpp"
#include "generator/lint/sensor_rules.hpp"
#include "generator/lint/type_rules.hpp"
#include "generator/lint/wrench_rules.hpp"

namespace finemote::gen {
namespace {

const Rule kRules[] = {
    {code::lint_unused_bus, "a bus is unused", find_unused_bus},
    {code::lint_bus_load, "a bus is heavily loaded", find_busy_bus},
    {code::timing_bus_overload, "a bus is overloaded", find_overloaded_bus},
    {code::lint_order, "a sensor is declared after actuators of the same period", find_late_sensors},
    {code::lint_period_ratio, "a period is neither a multiple nor a divisor of the parent's", find_odd_period},
    {code::lint_no_wcet, "a device has no `<wcet>`", find_missing_wcet},
    {code::lint_conversion, "a conversion takes longer than the period", find_long_conversion},
    {code::lint_param_replaced, "a param is ignored: its value is computed from the URDF", find_replaced_params},
    {code::lint_command_age, "a limit on the age of commands is below the proven age", find_old_commands},
    {code::lint_half_actuator, "an actuator takes no commands, or what takes commands is no actuator",
     find_half_actuators},
    {code::lint_wrench_axis, "the actuators cannot produce an axis of the wrench", find_missing_axes},
    {code::lint_wrench_effort, "an axis of the wrench takes excessive effort", find_weak_axes},
    {code::lint_out_of_reach, "a servo does not reach the limits of its joint", find_short_travel},
    {code::lint_no_mass, "an arm whose weight is carried has no mass", find_massless_chain},
    {code::lint_wheel_limits, "a wheel or thruster is on a joint that cannot turn round", find_limited_wheels},
    {code::lint_moved_joint, "constants depend on a joint that another device moves", find_moved_joints},
    {code::lint_sensor_place, "a sensor is not on what it measures for its device", find_misplaced_sensors},
    {code::lint_same_place, "two thrusters are in the same place", find_doubled_axes},
    {code::lint_param_range, "a param allows angles beyond the limits of the joint", find_wide_params},
    {code::lint_other_command, "a joint is commanded by ros2_control what its device does not take",
     find_other_commands},
    {code::lint_odd_output, "a pin leads nowhere, or an output is made for something else", find_odd_outputs},
};

}  // namespace

std::span<const Rule> lint_rules() { return kRules; }

std::vector<Rule> lint_rules_by_number() {
  std::vector<Rule> rules(std::begin(kRules), std::end(kRules));
  std::sort(rules.begin(), rules.end(), [](const Rule& a, const Rule& b) { return a.code.number < b.code.number; });
  return rules;
}

bool is_lint_code(Code code) {
  return std::any_of(std::begin(kRules), std::end(kRules), [&](const Rule& rule) { return rule.code == code; });
}

}  // namespace finemote::gen
