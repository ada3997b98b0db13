// The board that a word of the command line names.
#pragma once

#include <string>

#include "generator/descriptor/library.hpp"

namespace finemote::gen {

/// Null after FM3007, with the name that was likely meant, or after what is wrong with the board's file was reported.
const Board* named_board(const std::string& name, Library& library, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
