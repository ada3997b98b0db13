// A serial line nothing is at: buffers that stay empty.
#pragma once

#include "finemote/ports.hpp"

namespace finemote {

struct UartHardware {
  static constexpr std::size_t kTransmit = 64;
  std::uint8_t out[kTransmit]{};
};

}  // namespace finemote
