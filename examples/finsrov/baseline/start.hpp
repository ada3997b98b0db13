// From reset to a firmware's own loop: the runtime's start-up and timer, without its scheduler.
//
// A firmware defines `finemote_schedule` with one bucket, whose interrupt is its timer tick.
#pragma once

#include "finemote/schedule.hpp"

namespace baseline {

/// What a firmware does for ever, behind the start. Context: main, with the tick running.
[[noreturn]] void run();

/// A schedule that is nothing but a tick.
/// @param buckets  one
constexpr finemote::Schedule tick_alone(const char* name, finemote::Buckets buckets, void (*start_parts)()) {
  return {name, finemote::kMillisecond, buckets, finemote::Overrun::skip, start_parts, [] {}, nullptr};
}

}  // namespace baseline
