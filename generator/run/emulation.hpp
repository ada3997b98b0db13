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

/// A model of its part is on a bus of the board, or at an expander that has one there.
bool has_part(const Robot& robot, const Device& device);
bool has_part(const Robot& robot, const Expander& expander);

}  // namespace finemote::gen
