// A text that was read, to the file it is written back to.
#pragma once

#include <optional>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// What is on disk before the text: a byte order mark or nothing. None where the file is not that text, in UTF-8: it
/// cannot be edited without a loss, and FM5012 is reported.
std::optional<std::string> mark_before(const SourceFile& file, Sources& sources, Diagnostics& diagnostics);

}  // namespace finemote::gen
