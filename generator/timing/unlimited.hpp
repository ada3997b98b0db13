// The value of a count that nothing bounds.
#pragma once

#include <cstdint>
#include <limits>

namespace finemote::gen::timing {

/// As many as there can be.
inline constexpr std::int64_t kUnlimited = std::numeric_limits<std::int64_t>::max();

}  // namespace finemote::gen::timing
