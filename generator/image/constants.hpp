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

/// What a user's code may do to constants, of which debug information does not tell.
struct Liberties {
  bool has_mutable = false;  ///< classes of it may have `mutable` members
  bool makes_anew = false;   ///< any object may be made anew in its place, before main, say
};

/// Of all variables with static storage of the image at `path`. Reports FM6101 when the debug information cannot be
/// read; an image without any has no such members.
KeptMembers kept_members(const std::string& path, Liberties liberties, Diagnostics& diagnostics);

}  // namespace finemote::gen
