// A wait for hardware that always ends.
#pragma once

#include <cstdint>

#include "runtime/chips/stm32f4/registers/register.hpp"

namespace finemote::stm32f4 {

/// Polls until the masked bits have `value`. One poll takes at least four core cycles.
/// @return false when they have not after `polls` reads.
[[nodiscard]] inline bool wait_for(const Register& status, std::uint32_t mask, std::uint32_t value,
                                   std::uint32_t polls) {
  for (; polls != 0; --polls) {
    if ((status.read() & mask) == value) return true;
  }
  return false;
}

}  // namespace finemote::stm32f4
