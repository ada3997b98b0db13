// Everything a run writes into its work folder before the compiler starts, and the image that is made of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/clash.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/output/folder.hpp"
#include "generator/run/build_firmware.hpp"
#include "generator/run/parts.hpp"

namespace finemote::gen {

struct Project {
  FirmwareRequest request;
  Output generated;               ///< the robot's own files, below `generated`
  Output project;                 ///< what includes them, in the work folder itself
  std::string option = "--keep";  ///< that names the work folder
};

/// What any firmware of the robot is made of: its own board, where its code runs, and the sources of its own types.
/// @param folder  the work folder
FirmwareRequest firmware_of(const Robot& robot, std::string folder, std::string data_dir);

/// The project of `request` around the generated files, for the same robot and inputs.
/// @param parts  what hangs on the board, which is written down, too; null: that is not
Project make_project(const FirmwareRequest& request, Output generated, const Robot& robot, const EmulatedParts* parts);

/// Whether all of it, and the results, can be written: looked at before the first file is. Reports what check_outputs
/// and write_output report.
/// @param results  files beside the project; those with an empty path are not asked for
bool is_free_to_write(const Project& project, const std::vector<PlannedFile>& results, Sources& sources,
                      Diagnostics& diagnostics);

/// Writes the files. Reports what write_output reports. @return  whether they are there
bool write_project(const Project& project, Sources& sources, Diagnostics& diagnostics);

/// Writes the files and builds. Returns the path of the image; reports what write_output and build_firmware report.
std::optional<std::string> make_image(const Project& project, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
