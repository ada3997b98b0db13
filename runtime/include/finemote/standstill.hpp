// Tells a transfer that stands still from one that goes on late: more urgent interrupts may keep its routine waiting.
#pragma once

#include <cstdint>

#include "finemote/time.hpp"

namespace finemote {

/// Whoever looks at a bus is less urgent than all interrupts: at that instant a step of the transfer is under way on
/// the wire, or none will be. Where a step cannot last for so long, two looks that find the same number tell. One
/// context.
class Standstill {
 public:
  /// How long the transfer has stood still, below 4.2 s.
  /// @param number  grows with each step of a transfer and with each transfer, modulo 2^32
  /// @param at      while it was that
  [[nodiscard]] Duration lasts(std::uint32_t number, Time at) {
    const auto now = static_cast<std::uint32_t>(at);
    if (number != number_) {
      number_ = number;
      from_ = now;
    }
    return now - from_;
  }

 private:
  std::uint32_t number_ = 0;
  std::uint32_t from_ = 0;  ///< ns, modulo 2^32
};

}  // namespace finemote
