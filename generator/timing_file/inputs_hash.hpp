// What execution times depend on: all that makes the instructions of an image.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/render.hpp"
#include "generator/file/access.hpp"

namespace finemote::gen {

struct TimingInputs {
  const std::vector<OutputFile>& generated;  ///< without bounds in them
  std::string board;                         ///< a folder of runtime/boards
  std::string placement;                     ///< of the code: `flash`, `sram`
  std::string data_dir;                      ///< holds runtime and cmake
  std::vector<std::string> user_folders;     ///< of the robot's own device types
};

/// What execution times were computed from.
struct TimingState {
  std::string hash;                     ///< empty: a file is too large for it
  std::vector<std::string> user_files;  ///< paths of those that are in it
};

/// The hash: SHA-256 of the cost model, the board, the generated sources without the names of the files they were made
/// from, the runtime, the user's sources, what these include, and the compiler's options. The compiler is not in it: it
/// stands beside.
/// @param access  to the user's folders
TimingState timing_state(const TimingInputs& inputs, const files::Access& access);

/// SHA-256 of what is shipped of it: the runtime for a board, and the files that build it.
std::string shipped_digest(const std::string& data_dir, const std::string& board);

}  // namespace finemote::gen
