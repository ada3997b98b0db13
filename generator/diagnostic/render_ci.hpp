// Findings in the forms editors, code hosts and CI read.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

// Repeats of a finding in further expansions of one macro (repeats.hpp) stand with the first: as notes at the calls for
// gcc, in the message for GitHub, as `relatedLocations` and `occurrenceCount` for SARIF.

/// `file:line:col: error: message [FMnnnn]`, with notes as further lines: what editors know from compilers.
std::string render_gcc(const Diagnostics& diagnostics);

/// `::error file=...,line=...,col=...,title=FMnnnn::message`, escaped. GitHub shows ten of a kind in one step: the
/// first nine, and a tenth that counts the rest.
std::string render_github(const Diagnostics& diagnostics);

/// A SARIF 2.1.0 log of one run. Every result has a location: without a place, the file `input`, unless there is none;
/// addresses are relative.
nlohmann::ordered_json render_sarif(const Diagnostics& diagnostics, const std::string& tool_version,
                                    const std::string& input);

}  // namespace finemote::gen
