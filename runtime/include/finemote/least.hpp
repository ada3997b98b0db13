// The smaller of two counts, without all of <algorithm>.
#pragma once

#include <cstddef>

namespace finemote {

constexpr std::size_t least(std::size_t a, std::size_t b) { return a < b ? a : b; }

}  // namespace finemote
