// The name of a board, or of a file that describes one, to what the file says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace finemote::emulator {

/// A board file (finemote.board/1), laid over those it extends; members of those are looked for beside it, then among
/// the boards and chips that come with the program: in `share` beside it or one folder up in `share/finemote`, or where
/// the environment variable FINEMOTE_DATA says.
/// @param board  `robomaster_type_c`, or a path: with a `/`, or to a file that is there
/// @throws std::invalid_argument  there is no such board (with the names of those there are), or it is no JSON
nlohmann::ordered_json read_board_file(const std::string& board);

}  // namespace finemote::emulator
