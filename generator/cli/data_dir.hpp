// Finds the folder that holds schemas, templates and runtime.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// `wanted` (of --data-dir) unless it is empty, then the environment variable FINEMOTE_DATA, then beside the program's
/// real path: `share` (staged by the build) or `../share/finemote` (installed). Reports FM0007 and returns an empty
/// text when there is none.
std::string find_data_dir(const std::string& wanted, Diagnostics& diagnostics);

/// A file of that folder; reports FM0007 for one that is missing or cannot be read.
std::optional<std::string> read_data_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace finemote::gen
