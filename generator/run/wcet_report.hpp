// Bounds of execution times of an image, by the names of the robot: `finemote wcet`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/forest/forest.hpp"
#include "generator/forest/stage.hpp"
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

/// In the order of the table.
std::vector<Stage> stages_of(const TimedRobot& timed);

/// As the table names them: `imu.update`, `gimbal_can.CAN2_RX0`, `bucket 1 ms`, `release`.
std::string name_of(const TimedRobot& timed, Stage stage);
std::string name_of(const TimedRobot& timed, const wcet::RoutineTime& routine);

/// The bracket of a stage; null: its routine has no bound.
const wcet::BracketTime* bracket_of(const TimedRobot& timed, Stage stage);

/// A file and a line; the address where the image does not tell.
std::string code_place(std::uint32_t address, const TimedRobot& timed);

}  // namespace finemote::gen
