// Folders to descriptors: finds device types and boards by name, reads and checks each when it is first used.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/descriptor/board.hpp"
#include "generator/descriptor/device_type.hpp"
#include "generator/descriptor/expander_type.hpp"
#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// A descriptor, board or chip file that was found, and is read when something names it.
struct LibraryFile {
  std::string name;     ///< its name without `.json`: the type, board or chip it has to describe
  std::string path;     ///< to open it
  std::string display;  ///< `builtin:devices/ms5837.json`, or relative to the input
  bool builtin = true;
  bool failed = false;  ///< it was read and is wrong, which was reported
};

/// Descriptors, board and chip files that were found and, of these, loaded; owns what the robot points at.
struct Library {
  std::vector<LibraryFile> device_files;  ///< sorted by name
  std::vector<LibraryFile> board_files;
  std::vector<LibraryFile> chip_files;  ///< what boards extend
  std::vector<LibraryFile> expander_files;
  std::string schema_dir;  ///< where the JSON Schemas are
  std::vector<std::unique_ptr<DeviceType>> device_types;
  std::vector<std::unique_ptr<Board>> boards;
  std::vector<std::unique_ptr<ExpanderType>> expander_types;

  [[nodiscard]] const DeviceType* device_type(std::string_view name) const {
    for (const auto& t : device_types) {
      if (t->name == name) return t.get();
    }
    return nullptr;
  }
  [[nodiscard]] const Board* board(std::string_view name) const {
    for (const auto& b : boards) {
      if (b->name == name) return b.get();
    }
    return nullptr;
  }
};

struct LibraryOptions {
  std::string data_dir;   ///< holds `schemas/`
  std::string input_dir;  ///< folder of the robot's file; `devices/` in it is searched; empty: none
  std::vector<std::string> device_paths = {};  ///< further folders like that, as on the command line
  std::vector<std::string> board_paths = {};   ///< further folders of board and chip files
};

/// Lists what the folders hold; of the user's descriptors it looks whether they are of a device type or an expander.
/// Reports FM0007 when `data_dir` has no schemas (then there is no
/// library), FM0002 for a device path that is no folder, FM3106 for a type or expander that two folders define or that
/// hides a shipped one.
std::optional<Library> load_library(const LibraryOptions& options, Sources& sources, Diagnostics& diagnostics);

/// The device type called `name`, read on first use: checked by the JSON Schema (where it is not as it was shipped: a
/// test checks what is) and by code. Null when no file has that name, and when it is wrong; what is wrong with a file
/// is reported once, inside that file: FM3101 to FM3107.
const DeviceType* find_device_type(Library& library, std::string_view name, Sources& sources, Diagnostics& diagnostics);

/// The same for a board; a board file with `extends` is a JSON merge patch over another board or a chip.
const Board* find_board(Library& library, std::string_view name, Sources& sources, Diagnostics& diagnostics);

/// The same for the model of an expander.
const ExpanderType* find_expander_type(Library& library, std::string_view name, Sources& sources,
                                       Diagnostics& diagnostics);

/// Names of the types, boards and expander models that exist, sorted.
std::vector<std::string> device_type_names(const Library& library);
std::vector<std::string> board_names(const Library& library);
std::vector<std::string> expander_type_names(const Library& library);

/// The shipped board that hints and examples name. Reads board files: for messages only.
std::string suggested_board(Library& library, Sources& sources);

/// The same for the shipped mux.
std::string suggested_mux(Library& library, Sources& sources);

/// Reads and checks every file of the library with its schema, shipped ones too, chips with the boards they are on: for
/// tests and `finemote lint`.
void check_whole_library(Library& library, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
