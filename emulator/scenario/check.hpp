// A scenario's tree to everything that is wrong with it, each at its word.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "emulator/scenario/place.hpp"
#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"

namespace finemote::scenario {

/// What is there before the scenario is read.
struct World {
  struct Part {
    std::string name;
    std::string type;                           ///< of its model; empty: a device without one
    std::optional<Place> place = std::nullopt;  ///< none: not known
  };
  std::vector<Part> parts;
  std::optional<std::vector<std::string>> ports;  ///< of the robot's buses; none: every port of the board is in use
  std::vector<std::string> shared;                ///< ports at which several parts may send
  std::optional<std::int64_t> duration_ns;        ///< that the run lasts at most; none: not known
  std::map<std::string, unsigned> selects = {};   ///< chip selects of the board's SPI ports; empty: not known
  bool judges_wiring = true;                      ///< false: parts may stand in each other's way
};

/// Reports FM6004 (another form or type, a member missing), FM6007 (a name of nothing, with what was likely meant) and
/// FM6009 (a value out of range).
void check(const gen::json::Value& document, const World& world, gen::Diagnostics& diagnostics);

}  // namespace finemote::scenario
