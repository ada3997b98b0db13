// Which devices of a robot have a model on the emulated board, and what they turn there.
#pragma once

#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// The joint an actuator turns: its own, or, where it is the only actuator in it, that of the composite around it;
/// empty: none.
std::string driven_joint(const Robot& robot, const Device& device);

/// The actuators with a model on the board in the tree of a device, itself included.
std::vector<const Device*> actuators_in(const Robot& robot, const Device& device);

/// A model of its part is on a bus of the board.
inline bool has_part(const Device& device) { return device.segment && !device.type->emulation.part.empty(); }

}  // namespace finemote::gen
