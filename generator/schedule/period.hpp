// Writes periods the way generated names and comments spell them.
#pragma once

#include <cstdint>
#include <string>

namespace finemote::gen {

/// The largest of s, ms, us, ns that divides it: 10000000 -> `10ms`, 2500000 -> `2500us`. Requires ns > 0.
std::string period_label(std::int64_t period_ns);

/// The same with a blank, for comments: `10 ms`.
std::string period_text(std::int64_t period_ns);

}  // namespace finemote::gen
