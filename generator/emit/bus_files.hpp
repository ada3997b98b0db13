// The files that define one object per bus and expander, their transfer slots and routing tables.
#pragma once

#include "generator/emit/names.hpp"

namespace finemote::gen {

Data bus_header(const Plan& plan);
Data bus_source(const Plan& plan);

}  // namespace finemote::gen
