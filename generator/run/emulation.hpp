// What descriptors say of their models on the emulated board.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// `emulation` of a descriptor, or null.
inline nlohmann::ordered_json emulation_of(const DeviceType& type) {
  return type.descriptor->value("emulation", nlohmann::ordered_json());
}

/// The joint an actuator turns: its own, or, where it is the only actuator in it, that of the composite around it;
/// empty: none.
std::string driven_joint(const Robot& robot, const Device& device);

/// The actuators with a model on the board in the tree of a device, itself included.
std::vector<const Device*> actuators_in(const Robot& robot, const Device& device);

/// A model of its part is on a bus of the board.
inline bool has_part(const Device& device) { return device.segment && emulation_of(*device.type).contains("part"); }

}  // namespace finemote::gen
