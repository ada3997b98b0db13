// `strict` and `strict:NAME,..` to the freedom of its manual that the emulated chip uses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::emulator {

/// The names that were asked for, in the order of strictnesses(): all of them with `strict` alone, none with an empty
/// text. Reports words that are no names as wrong usage.
std::optional<std::vector<std::string>> parse_silicon(const std::string& text, gen::Diagnostics& diagnostics);

}  // namespace finemote::emulator
