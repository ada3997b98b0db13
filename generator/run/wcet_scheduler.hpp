// What jobs, releases and interrupts take beside the stages, as `finemote.wcet/1` says it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "generator/run/wcet_report.hpp"

namespace finemote::gen {

/// A routine of the scheduler: the release, or a bucket with all that it runs.
struct SchedulerTask {
  std::string name;                               ///< `release`, `bucket 5 ms`
  std::optional<Duration> period = std::nullopt;  ///< none: the release
};

/// Of an exception; none: it is none of the scheduler's.
std::optional<SchedulerTask> task_of(const TimedRobot& timed, unsigned exception);

/// Rounded up.
std::int64_t ns_of(wcet::Cycles cycles, const TimedRobot& timed);

/// Routines of interrupts that are none of the robot's: it is unknown how often they run, so nothing that they
/// interrupt has a bound.
std::vector<wcet::TimeGap> foreign_routines(const TimedRobot& timed);

/// Stages without a bound although everything that was walked has one: their routine never comes to their end.
std::vector<wcet::TimeGap> vanished_stages(const TimedRobot& timed);

/// The members `interrupts` and `scheduler`.
nlohmann::ordered_json interrupts_json(const TimedRobot& timed);
nlohmann::ordered_json scheduler_json(const TimedRobot& timed);

/// The bus and line that a routine serves, `i2c.I2C2_EV`, else the name of the routine.
std::string interrupt_name(const TimedRobot& timed, const wcet::RoutineTime& routine);

}  // namespace finemote::gen
