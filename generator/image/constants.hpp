// Parts of an image's variables that keep a value, by what the debug information says of their types.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// Bytes [begin, end) of memory.
struct ImageRange {
  std::uint32_t begin = 0, end = 0;
};

struct KeptMembers {
  /// `const` members of variables, and references: what the image holds there, where that is not written before main.
  /// Variables that are `const` themselves are not in it: they lie in read-only sections, or something writes to them.
  std::vector<ImageRange> constant;
  std::vector<ImageRange> constant_in_functions;  ///< the same of `static` variables there, which may be set late
  std::vector<ImageRange> at_start;               ///< members of type finemote::AtStart: what start-up writes there
};

/// Whose classes have no `mutable` member: debug information does not tell of them.
enum class NoMutable {
  of_anybody,
  of_finemote,  ///< and of none of the standard library: a user's may
};

/// Of all variables with static storage of the image at `path`. Reports FM6101 when the debug information cannot be
/// read; an image without any has no such members.
KeptMembers kept_members(const std::string& path, NoMutable no_mutable, Diagnostics& diagnostics);

}  // namespace finemote::gen
