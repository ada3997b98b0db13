// How long the interrupt routines of the robot's buses take by themselves.
#pragma once

#include <cstdint>

namespace finemote::bench_kit {

/// From now on every line of a bus leads to its routine through a stopwatch, by a copy of the vector table in RAM.
/// Nothing interrupts a routine meanwhile.
void watch_routines();

/// The longest run of a routine of this bus, without the way into it and back [cycles]; 0: there was none.
std::uint32_t longest_routine(unsigned bus);

}  // namespace finemote::bench_kit
