// Bounds of execution times of an image, by the names of the robot: `finemote wcet`.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/forest/forest.hpp"
#include "generator/image/source_lines.hpp"
#include "generator/model/robot.hpp"
#include "generator/run/source_names.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/wcet/image_times.hpp"

namespace finemote::gen {

/// What computed the bounds, and from what.
struct WcetInputs {
  wcet::Placement placement = wcet::Placement::flash;
  std::int64_t clock_hz = 0;
  std::string compiler = {}, hash = {};     ///< empty for an image that was linked elsewhere
  std::vector<std::string> arguments = {};  ///< NAME:=VALUE
  std::string board = {};                   ///< that was asked for instead of the robot's own; empty: none
};

/// An image of this robot with its bounds; all outlive the report.
struct TimedRobot {
  const Robot& robot;
  const Forest& forest;
  const Schedule& schedule;
  const wcet::ImageTimes& times;
  const SourceLines& lines;
  const SourceNames& names;
  WcetInputs inputs;
};

/// As `finemote.wcet/1`: docs/wcet.md.
nlohmann::ordered_json wcet_document(const TimedRobot& timed);

/// The same as a table, with what has no bound below it.
std::string wcet_text(const TimedRobot& timed);

/// The longest way through a stage line by line, as `imu.update` names it; none: there is no such stage, or no bound.
std::optional<std::string> explain_stage(const TimedRobot& timed, const std::string& stage);

}  // namespace finemote::gen
