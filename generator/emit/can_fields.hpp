// What a slot on CAN knows of frames: which its part sends, and its share of one that several parts are commanded by.
#pragma once

#include "generator/emit/names.hpp"
#include "generator/tasks/bounds.hpp"

namespace finemote::gen {

/// Sets what templates/slot.mustache and its parts ask for a slot of the bus, which takes identifiers.
void set_can(const Plan& plan, const timing::RobotBounds& bounds, const Slot& slot, Data& data);

}  // namespace finemote::gen
