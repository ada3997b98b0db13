// The files that define one object per bus and expander, their transfer slots and routing tables.
#pragma once

#include "generator/emit/names.hpp"
#include "generator/tasks/bounds.hpp"

namespace finemote::gen {

Data bus_header(const Plan& plan, const timing::RobotBounds& bounds);
Data bus_source(const Plan& plan, const timing::RobotBounds& bounds);

}  // namespace finemote::gen
