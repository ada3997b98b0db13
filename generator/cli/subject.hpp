// IN to what the timing analysis is given: the tasks of a robot, or those of a `.json` model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/pipeline.hpp"
#include "generator/tasks/from_robot.hpp"

namespace finemote::gen {

struct Subject {
  timing::Model model;
  std::vector<timing::Requirement> requirements;  ///< of a robot
  std::optional<PlannedRobot> planned;            ///< what the model was made from; none: it was read as it is
};

/// @param robot_options  for the tasks of a robot
std::optional<Subject> read_subject(const Options& options, const timing::RobotTimingOptions& robot_options,
                                    Sources& sources, Diagnostics& diagnostics);

/// The value of an option that is a time; none where it is not given, or wrong: then FM0001 is reported, with
/// `example` in the hint.
std::optional<Duration> time_option(const char* option, const std::string& text, const char* example,
                                    Diagnostics& diagnostics);

/// The same of --duration, which is a day at most: longer ones would seem to hang.
/// @param gone_through  what that time is made of
std::optional<Duration> duration_option(const Options& options, const char* example, const char* gone_through,
                                        Diagnostics& diagnostics);

/// The value of --profile; none where it is not given, or wrong: then FM0001 is reported.
std::optional<timing::Profile> profile_option(const std::string& name, Diagnostics& diagnostics);

}  // namespace finemote::gen
