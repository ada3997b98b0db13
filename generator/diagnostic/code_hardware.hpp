// Numbers of what pins and pulse outputs of a board cannot be used for; the others are in code.hpp.
#pragma once

#include "generator/diagnostic/code.hpp"

namespace finemote::gen::code {

inline constexpr Code pin_reserved{3206};        // the board wires the pin to something of its own
inline constexpr Code pulse_period{3207};        // a pulse as long as the time between two, or longer
inline constexpr Code lint_odd_output{3208};     // a pin that leads nowhere, an output made for something else
inline constexpr Code output_not_tunable{3209};  // a device sets the period of an output that others share

}  // namespace finemote::gen::code
