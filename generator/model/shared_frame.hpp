// The command frame on CAN that a device fills together with others.
#pragma once

#include "generator/model/robot.hpp"

namespace finemote::gen {

/// None: it fills none, or lacks its type, its bus or the id its type needs. A type without ids is as its id 0.
std::optional<SharedFrame> shared_frame_of(const Device& device);

}  // namespace finemote::gen
