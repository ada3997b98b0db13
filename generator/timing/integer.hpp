// Times of the analysis, and the failure of one that takes too long.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "generator/units/checked.hpp"

namespace finemote::gen::timing {

using Ns = std::int64_t;  ///< nanoseconds, or an exact quantity beside them

/// The analysis would take longer than its budget of steps; becomes FM4011.
struct TooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace finemote::gen::timing
