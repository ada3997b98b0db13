// How long what a sender is given for is under way where its clock is as slow as can be understood.
#pragma once

#include "generator/units/checked.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// A sender on a serial line is understood whose clock is off by one part in 22 at most (RM0090 30.3.5): its bytes take
/// as much longer. Rounded up. wire >= 0.
constexpr Duration of_slow_sender(Duration wire) { return wire + ceil_div(wire, 22); }

}  // namespace finemote::gen
