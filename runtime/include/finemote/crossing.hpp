// Bounds what a value may weigh that the schedule copies between periods or trees.
#pragma once

#include <cstddef>

namespace finemote {

/// Largest value the generated schedule copies, in bytes: the timing analysis counts every copy as so many (32 words).
inline constexpr std::size_t kCrossingBytes = 128;

/// Refuses to compile for a State or Command whose copy would take longer than the analysis counts.
template <class T>
struct CheckedCrossing {
  static_assert(
      sizeof(T) <= kCrossingBytes,
      "a State or Command that crosses periods or trees has at most finemote::kCrossingBytes (128) bytes: the "
      "timing analysis counts no more for its copy; split it, or give both devices one period and tree");
  static constexpr bool ok = true;  ///< what a static_assert asks for
};

}  // namespace finemote
