// A wait for hardware that always ends.
#pragma once

#include <cstdint>

#include "runtime/boards/robomaster_type_c/registers/register.hpp"

namespace finemote::robomaster_type_c {

/// Polls until the masked bits have `value`. One poll takes at least four core cycles.
/// @return false when they have not after `polls` reads.
[[nodiscard]] inline bool wait_for(const stm32f407::Register& status, std::uint32_t mask, std::uint32_t value,
                                   std::uint32_t polls) {
  for (; polls != 0; --polls) {
    if ((status.read() & mask) == value) return true;
  }
  return false;
}

}  // namespace finemote::robomaster_type_c
