// A link to a computer.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"

namespace finemote {

/// Valid while commands come in.
struct LinkState : Stamp {
  std::uint32_t frames = 0;      ///< good ones received
  std::uint32_t rejected = 0;    ///< damaged: size or checksum
  std::uint32_t mismatched = 0;  ///< whole, but of another layout: the other end was built from another description
  std::uint32_t sent = 0;        ///< frames that left
};

/// Offered by links to computers; what the computer commands goes to the devices below the link.
struct Link {
  using State = LinkState;
  using Command = void;
};

}  // namespace finemote
