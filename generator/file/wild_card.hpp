// A wild card of the shell against the name of one file.
#pragma once

#include <string_view>

namespace finemote::gen::files {

/// Whether a component of a path has `*`, `?` or `[` in it.
bool is_wild(std::string_view component);

/// What fnmatch() with FNM_PERIOD answers for names without '/': `*`, `?`, `[a-z]`, `[!a-z]`, `\` before a letter that
/// stands for itself; a leading dot is matched by a dot alone. Takes no longer than the product of both lengths, where
/// fnmatch() tries every way to share a name among many `*`.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace finemote::gen::files
