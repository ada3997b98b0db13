// Timing results to the tables people read.
#pragma once

#include <string>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// `104.5 us`: three decimals at most, rounded up, so that a printed bound is never below the computed one.
std::string duration_text(Duration time);
std::string duration_text(std::optional<Duration> time);  ///< `-` for none

/// Of the asked profile: the verdict on one line, buckets, who uses the processor, devices, trees, chains, buses and
/// requirements; last the figures that decide nothing.
std::string timing_table(const Timing& timing);

}  // namespace finemote::gen::timing
