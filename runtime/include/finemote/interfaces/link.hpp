// A link to a computer.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace finemote {

/// Valid while commands come in.
struct LinkState : Stamp {
  std::uint32_t frames = 0;    ///< good ones received
  std::uint32_t rejected = 0;  ///< damaged: size or checksum
  /// Whole, but of another layout: the other end was built from another description. One an update() at most.
  std::uint32_t mismatched = 0;
  std::uint32_t sent = 0;  ///< frames that left
};

/// Offered by links to computers; what the computer commands goes to the devices below the link.
struct Link {
  using State = LinkState;
  using Command = void;
};

}  // namespace finemote
