// Between which times an event happened that an interrupt tells of.
#pragma once

#include "finemote/time.hpp"

namespace finemote {

/// When an event happened that an interrupt tells of: the routine may have waited for others.
struct Moment {
  Time earliest = kLongAgo;  ///< kLongAgo where its routine ran before the first release
  Time latest = 0;           ///< when the routine looked

  /// Its routine ran before the first release: nobody can say how long.
  [[nodiscard]] constexpr bool before_start() const { return latest == 0; }
};

}  // namespace finemote
