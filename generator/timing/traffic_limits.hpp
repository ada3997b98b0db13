// The most that buses carry, and that they interrupt, in a time: what a run can be held to.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// None: nothing bounds it.
struct TrafficLimit {
  std::optional<Duration> wire;      ///< occupation of its wire; where it has two lines, of that the board sends on
  std::optional<Duration> received;  ///< two lines: of that it receives on
  std::optional<std::int64_t> interrupts;  ///< runs of all of its service routines
};

/// In any window of that length, from the end of the bring-up on. May throw Overflow.
Table<BusPlace, TrafficLimit> traffic_limits(const Model& model, Duration window);

}  // namespace finemote::gen::timing
