// Two analyses to what changed between them.
#pragma once

#include <string>

#include "generator/report/documents.hpp"

namespace finemote::gen::report {

/// A sentence that counts, and a table of what is another now: devices, own times, bounds, loads, requirements. Says in
/// words what is better or worse. Empty where there is nothing to compare with.
std::string changes_of(const Documents& documents);

/// By chain: its end-to-end bound before, as cells of a table that the script draws from.
std::string earlier_bounds(const Documents& documents);

}  // namespace finemote::gen::report
