// The bounds of a chain to notes that say which part of it is the largest, and who makes it so.
#pragma once

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

/// Adds them to a finding about the chain, which is one of the analysed model.
/// @param decision_only  acquisition and wire are not asked about
void explain_chain(const Timing& timing, const ChainResult& chain, bool decision_only, Diagnostic& finding);

}  // namespace finemote::gen::timing
