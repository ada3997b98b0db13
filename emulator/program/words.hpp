// The words of the command line to what is to be watched, and to what is said of them: usage and manual page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emulator/program/watch.hpp"

namespace finemote::emulator {

/// The options of a watch; nothing where no image is named. @throws std::invalid_argument where a word is none of them
std::optional<WatchOptions> watch_options(const std::vector<std::string>& words);

std::string usage();
/// In roff, for section 1.
std::string manual_page();

}  // namespace finemote::emulator
