// Turns findings into the text people read, and into the forms editors and CI read.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// `file:line:col: error[FMnnnn]: message`, excerpt with caret, notes and hints; colours when `color`. Repeats of a
/// finding in further expansions of one macro are a note of the first (repeats.hpp).
std::string render_text(const Diagnostics& diagnostics, bool color);

/// The `diagnostics` array of every JSON document: [{severity, code, message, file, line, column, notes, hints}].
/// A finding with repeats has them in `repeats`: [{message, file, line, column}], at the outermost macro calls.
nlohmann::ordered_json render_json(const Diagnostics& diagnostics);

/// `error`, `warning`, `note`.
const char* severity_name(Severity severity);

/// `FM0042`.
std::string code_name(Code code);

}  // namespace finemote::gen
