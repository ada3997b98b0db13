// Whether data of a model could be older than itself.
#pragma once

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/timing/model.hpp"

namespace finemote::gen::timing {

/// Reports FM4014 for every device that closes a cycle of parents and `reads` edges.
void check_cycles(const Model& model, Diagnostics& diagnostics);

}  // namespace finemote::gen::timing
