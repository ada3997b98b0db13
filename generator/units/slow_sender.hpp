// Wire time of a frame from the slowest sender that the receiver still understands.
#pragma once

#include "generator/units/checked.hpp"
#include "generator/units/duration.hpp"

namespace finemote::gen {

/// A sender on a serial line is understood up to 3.75 % off (RM0090 30.3.5): its bytes take up to 3.9 % longer. One
/// part in 22 covers that, and is what the firmware subtracts where it dates a frame (runtime/src/uart.cpp). Rounded
/// up. wire >= 0.
constexpr Duration of_slow_sender(Duration wire) { return wire + ceil_div(wire, 22); }

}  // namespace finemote::gen
