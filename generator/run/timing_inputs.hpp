// What execution times depend on: all that makes the instructions of an image.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/emit/render.hpp"
#include "generator/run/build_firmware.hpp"

namespace finemote::gen {

/// SHA-256 of the generated sources without the names of the files they were made from, the runtime, the user's sources
/// and the compiler's options. The compiler is not in it: it stands beside.
/// @param generated  without bounds in them
std::string timing_hash(const std::vector<OutputFile>& generated, const FirmwareRequest& request);

/// The first line of what the compiler for the board says of itself; empty: it is not there.
std::string compiler_for_board();

}  // namespace finemote::gen
