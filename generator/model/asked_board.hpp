// Whether `--board` changes anything.
#pragma once

#include <string>

#include "generator/xml/node.hpp"

namespace finemote::gen {

/// `board`, where the document names another one, or none; empty: with the robot's own board the robot is as it is
/// without the option.
std::string asked_board(const xml::Document& document, const std::string& board);

}  // namespace finemote::gen
