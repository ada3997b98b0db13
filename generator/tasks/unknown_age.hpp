// Whether a robot's description tells how old the data of a device are.
#pragma once

#include "generator/model/robot.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// Whether a converter of the chip measures for it.
bool measures_pins(const gen::Device& device);

/// Why it does not, where the part of the device sends it some.
UnknownAge unknown_age(const Robot& robot, const gen::Device& device);

}  // namespace finemote::gen::timing
