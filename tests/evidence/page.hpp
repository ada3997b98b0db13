// From the verdicts on all vectors to the tables of docs/reference/evidence.md.
#pragma once

#include <string>
#include <vector>

#include "tests/evidence/judge.hpp"

namespace finemote::evidence {

/// One row per protocol and source.
std::string table_of_sources(const std::vector<Vector>& vectors);
/// One row per explanation.
std::string table_of_explanations();

/// `page` with `table` between `<!-- name -->` and `<!-- end of name -->`.
/// @throws std::runtime_error  the page has no such place
std::string with_table(const std::string& page, const std::string& name, const std::string& table);

}  // namespace finemote::evidence
