// What descriptors say of their models on the emulated board.
#pragma once

#include <nlohmann/json.hpp>

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// `emulation` of a descriptor, or null.
inline nlohmann::ordered_json emulation_of(const DeviceType& type) {
  return type.descriptor->value("emulation", nlohmann::ordered_json());
}

/// A model of its part is on a bus of the board.
inline bool has_part(const Device& device) { return device.segment && emulation_of(*device.type).contains("part"); }

}  // namespace finemote::gen
