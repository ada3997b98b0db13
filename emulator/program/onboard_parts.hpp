// A board file and a scenario to what hangs on the board: the parts soldered to it, unless the scenario has its own
// there.
#pragma once

#include <nlohmann/json.hpp>

#include "emulator/scenario/check.hpp"

namespace finemote::emulator {

/// The board's parts as a document finemote.scenario/1. One that `scenario` has a part of the same name for, or of the
/// same type at the same port, is left out.
/// @param board     a board file (finemote.board/1), whose member `on_board` lists them
/// @param scenario  null: none
nlohmann::ordered_json onboard_parts(const nlohmann::ordered_json& board, const nlohmann::ordered_json& scenario);

/// The world a scenario finds on that board: these parts at their places, and the board's chip selects.
scenario::World world_of(const nlohmann::ordered_json& board, const nlohmann::ordered_json& parts);

}  // namespace finemote::emulator
