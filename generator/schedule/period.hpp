// Writes periods the way generated names and comments spell them.
#pragma once

#include <string>

#include "generator/units/duration.hpp"

namespace finemote::gen {

/// The largest of s, ms, us, ns that divides it: `10ms`, `2500us`. Requires period > 0.
std::string period_label(Duration period);

/// The same with a blank, for comments: `10 ms`.
std::string period_text(Duration period);

}  // namespace finemote::gen
