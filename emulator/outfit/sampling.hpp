// Entries of parts that take samples by themselves, on a clock of their own.
#pragma once

#include "emulator/outfit/entry.hpp"
#include "emulator/parts/own_clock.hpp"
#include "emulator/scenario/build.hpp"

namespace finemote::emulator {

/// How much faster the clock of a part runs than the board's: `clock_ppm`.
scenario::Member clock_error();
/// `clock_ppm` and `phase_ns`, without a period: the part's registers say which.
std::vector<scenario::Member> sampling();
/// The clock that such an entry describes.
OwnClock own_clock(PartClock board, const Json& entry);

}  // namespace finemote::emulator
