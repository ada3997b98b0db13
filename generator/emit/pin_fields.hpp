// The pins that buses and devices bring up at the start: what templates/pin_start.mustache names.
#pragma once

#include "generator/emit/names.hpp"

namespace finemote::gen {

/// Sets `pin_letter` and `pin_number` of a pin like `PA0`.
void set_pin(const std::string& pin, Data& data);

/// Pins that turn the direction of a bus.
Data driver_pins(const Plan& plan);

/// Pins that devices sit on or use, in the order of their devices.
Data pin_list(const Plan& plan);

}  // namespace finemote::gen
