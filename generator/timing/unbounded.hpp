// Why a chain has no bound, and what gives it one.
#pragma once

#include "generator/timing/remedy.hpp"

namespace finemote::gen::timing {

/// Looks into every chain of `timing` that has no end-to-end bound. Chains that lack theirs for one reason share it.
std::vector<MissingBound> missing_bounds(const Timing& timing, Trials& trials);

}  // namespace finemote::gen::timing
