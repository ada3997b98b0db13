// A board file to what the runtime compiles for the board: port objects and their names, clocks, memory, resting pins.
//
// The files lie in runtime/boards/<board>/generated, so that firmware is built without the generator. One port is one
// file: ports are linked from a library, and with a port come its buffers and its interrupt routines.
#pragma once

#include <string>
#include <vector>

#include "generator/descriptor/board.hpp"
#include "generator/emit/render.hpp"

namespace finemote::gen {

/// Why there can be no sources: memory is missing, or two boards that the board stands in for have a port of one name
/// and of different kinds; empty: there can.
std::vector<std::string> mistakes_for_sources(const Board& board, const std::vector<const Board*>& all);

/// In a fixed order. `all` are the boards whose ports a board that stands in for others has, in order of name; of two
/// ports of one name the first counts. A file that is none of these and has their first line is of an older board file.
/// The board has no mistakes_for_sources().
std::vector<OutputFile> board_sources(const Board& board, const std::vector<const Board*>& all,
                                      const std::string& data_dir);

}  // namespace finemote::gen
