// Interrupts a device causes beyond those of its bus: `interrupts` of a device descriptor.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "generator/units/duration.hpp"

namespace finemote::gen {

struct Interrupt {
  std::string source;          ///< what raises it, for people
  std::string use;             ///< the line that raises it; empty: the entry is documentation, the driver raises it
  bool is_autonomous = false;  ///< by itself, at least `min_interval` apart; else `count` per own period
  std::int64_t count = 1;
  std::optional<Duration> min_interval;  ///< by the part's own clock
  std::optional<Duration> wcet;          ///< none: that of the bus driver
};

/// Reads an entry that the schema accepts.
Interrupt read_interrupt(const nlohmann::ordered_json& value);

}  // namespace finemote::gen
