// Whether tests write what they expect.
#pragma once

#include <cstdlib>
#include <string_view>

namespace finemote::test {

/// FINEMOTE_UPDATE_GOLDEN=1, as `./dev golden` sets it: what differs is written, and is to be read as carefully as
/// code.
inline bool rewrites() {
  const char* wish = std::getenv("FINEMOTE_UPDATE_GOLDEN");
  return wish != nullptr && std::string_view(wish) == "1";
}

}  // namespace finemote::test
