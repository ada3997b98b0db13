// What a run has shown, to what a stranger wants to know of it first.
#pragma once

#include <ostream>

#include "generator/run/run_result.hpp"

namespace finemote::gen {

/// A few lines without a blank one: bounds held or not, the worst age of a command beside its bound, order, overruns,
/// deadlines.
void print_summary(const RunResult& result, std::ostream& out);

/// Most judged of a chain: end to end, where that has samples, else its decision.
const Measured& whole_of(const MeasuredChain& chain);

}  // namespace finemote::gen
