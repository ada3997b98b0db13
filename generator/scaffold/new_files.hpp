// Writes files that are not there yet, all or none.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/emit/render.hpp"

namespace finemote::gen {

/// Whether none of `names` is there below `folder`. Reports FM5015 for each that is: nothing of a user is overwritten.
bool are_new(const std::string& folder, const std::vector<std::string>& names, Diagnostics& diagnostics);

/// Writes the files, which are new. Reports FM5002 with the system's reason where one cannot be written; those that
/// were written before it are removed again. @return  whether all were
bool write_new(const std::string& folder, const std::vector<OutputFile>& files, Diagnostics& diagnostics);

}  // namespace finemote::gen
