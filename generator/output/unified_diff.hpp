// Two texts to a unified diff.
#pragma once

#include <string>

namespace finemote::gen {

/// Empty when equal; else `--- old_name`, `+++ new_name` and hunks with three lines of context.
std::string unified_diff(const std::string& old_name, const std::string& old_text, const std::string& new_name,
                         const std::string& new_text);

}  // namespace finemote::gen
