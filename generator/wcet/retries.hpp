// What it costs that an interrupt makes a loop run one more iteration.
#pragma once

#include <array>

#include "generator/wcet/walk.hpp"

namespace finemote::gen::wcet {

/// By RetriedBy: the longest iteration that such an interrupt adds to what it comes into.
using RetryTimes = std::array<Cycles, kKindsOfRetry>;

/// Takes the longer of `times` and those of the routine that was walked.
void take_retries(const Walked& walked, RetryTimes& times);

}  // namespace finemote::gen::wcet
