// Writes periods the way generated comments and tables spell them.
#pragma once

#include <string>

#include "generator/units/units.hpp"

namespace finemote::gen {

/// With a blank: `10 ms`.
inline std::string period_text(Duration period) { return units::format_duration(period, " "); }

}  // namespace finemote::gen
