// Folders to descriptors: finds device types and boards by name, reads and checks each when it is first used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

struct LibraryOptions {
  std::string data_dir;   ///< holds `schemas/`
  std::string input_dir;  ///< folder of the robot's file; `devices/` in it is searched; empty: none
  std::vector<std::string> device_paths = {};  ///< further folders of device descriptors, as on the command line
  std::vector<std::string> board_paths = {};   ///< further folders of board files
};

/// Lists what the folders hold; opens nothing. Reports FM0007 when `data_dir` has no schemas (then there is no
/// library), FM0002 for a device path that is no folder, FM3106 for a type that two folders define or that hides a
/// shipped one.
std::optional<Library> load_library(const LibraryOptions& options, Sources& sources, Diagnostics& diagnostics);

/// The device type called `name`, read on first use: checked by the JSON Schema (the user's own only: a test checks the
/// shipped ones) and by code. Null when no file has that name, and when it is wrong; what is wrong with a file is
/// reported once, inside that file: FM3101 to FM3107.
const DeviceType* find_device_type(Library& library, std::string_view name, Sources& sources, Diagnostics& diagnostics);

/// The same for a board; `extends` in a board file is a JSON merge patch over another.
const Board* find_board(Library& library, std::string_view name, Sources& sources, Diagnostics& diagnostics);

/// The same for the model of an expander.
const ExpanderType* find_expander_type(Library& library, std::string_view name, Sources& sources,
                                       Diagnostics& diagnostics);

/// Names of the types, boards and expander models that exist, sorted.
std::vector<std::string> device_type_names(const Library& library);
std::vector<std::string> board_names(const Library& library);
std::vector<std::string> expander_type_names(const Library& library);

/// Reads and checks every file of the library with its schema, shipped ones too: for tests and `finemote lint`.
void check_whole_library(Library& library, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
