// What every board does between reset and the first release.
#pragma once

#include <cstdint>

#include "finemote/schedule.hpp"

namespace finemote::detail {

/// What a board's release timer can do.
struct ReleaseTimer {
  Duration longest_tick;       ///< longest time between two releases; below 4 s
  std::uint32_t tick_unit_ns;  ///< a tick is a whole number of these
  bool one_word;               ///< all lines must share an interrupt controller word of 32
};

/// Verifies construction order and schedule; stops with a fault and a text when the robot cannot run.
/// Then starts the buses and sends the safe outputs: they are the first transfer after any reset.
void start_robot(const Schedule& schedule, const ReleaseTimer& timer);

/// True once the outputs may be driven: start_robot() has come to its end.
bool outputs_started();

/// Of stop_safely(): no bucket runs any more, and none that was preempted goes on. Context: any.
void set_stopped(bool is_stopped);
[[nodiscard]] bool has_stopped();

}  // namespace finemote::detail
