// What finemote init is about to write, planned before anything is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/emit/render.hpp"

namespace finemote::gen {

struct NewProject {
  std::string robot_file;              ///< below src/
  std::vector<OutputFile> files;       ///< by name; without the generated ones
  std::vector<std::string> generated;  ///< names of those
};

/// The project for the robot of --from or --example, or for one of its own on the board of --board. Reports FM0001 for
/// an example that does not exist and a board without LED and key, FM5016 where the robot reads what is not below its
/// folder, and what plan_robot reports of the robot.
std::optional<NewProject> plan_project(const Options& options, const std::string& data_dir, Sources& sources,
                                       Diagnostics& diagnostics);

}  // namespace finemote::gen
