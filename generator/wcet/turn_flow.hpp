// What one iteration of a loop hands on to the next in registers, whatever they hold.
#pragma once

#include <cstdint>
#include <set>

#include "generator/image/program.hpp"

namespace finemote::gen::wcet {

struct TurnFlow {
  std::set<int> carried;  ///< by capstone name: the next iteration reads what this one has written
  /// How often it iterated may make a difference: what is carried is made of what was, or it writes memory or calls.
  bool accumulates = false;
};

/// @param turn  blocks by their starts, the header among them
TurnFlow turn_flow(const ProgramFunction& function, const std::set<std::uint32_t>& turn, std::uint32_t header);

}  // namespace finemote::gen::wcet
