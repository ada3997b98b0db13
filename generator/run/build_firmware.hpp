// Generated sources to an executable for a board, with CMake and the runtime's own build functions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

struct FirmwareRequest {
  std::string name = "firmware";  ///< of the executable
  std::string folder;             ///< work folder: holds CMakeLists.txt and `generated`; `build` is made
  std::string data_dir;           ///< holds runtime and cmake
  std::string board;              ///< folder below runtime/boards
  bool for_host = false;          ///< the board is this computer: no cross compiler
  Duration duration;              ///< the run ends by itself; 0: never
  std::uint32_t stack = 0;        ///< bytes to reserve; 0: as many as the board does
  bool code_in_sram = false;      ///< for a board that can: its param `code`
  bool is_reproducible = false;   ///< what says when it was compiled does not compile
  bool trace = false;
  bool monitor = false;
  std::vector<std::string> include_dirs;  ///< of the user's own device types
  std::vector<std::string> sources;       ///< and their sources
};

/// In the build folder: where the compiler has headers of its own, with `;` between them.
inline constexpr const char* kCompilerFolders = "compiler_folders.txt";

/// Words of a CMake list: each path absolute, in brackets that nothing in it ends.
std::string cmake_words(const std::vector<std::string>& paths);

/// The CMakeLists.txt of the work folder.
std::string project_text(const FirmwareRequest& request);

/// Where the executable will be.
std::string image_path(const FirmwareRequest& request);

/// Whether CMake, Ninja and the compiler are there.
bool can_build(const FirmwareRequest& request);

/// Builds and returns the path of the executable. Reports FM0006 when CMake, Ninja or the compiler is missing and
/// FM6001 with the compiler's words when the sources do not compile.
std::optional<std::string> build_firmware(const FirmwareRequest& request, Diagnostics& diagnostics);

}  // namespace finemote::gen
