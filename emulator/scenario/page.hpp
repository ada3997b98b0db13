// The table of a scenario to the tables of docs/reference/emulator.md.
#pragma once

#include <string>

namespace finemote::scenario {

std::string parts_table();    ///< models, with the figures of their entries
std::string actions_table();  ///< what can happen, with members
std::string values_table();   ///< what can be looked at

}  // namespace finemote::scenario
