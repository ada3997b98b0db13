// Waits for hardware that always end.
#pragma once

#include <cstdint>

#include "finemote/loop_bound.hpp"
#include "runtime/chips/cortex_m4/core.hpp"
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

/// The same until `limit` cycles of the core have passed since the cycle count was `begin`: for interrupt routines,
/// whose waits the timing analysis charges. Each look comes behind the count it is judged by: a more urgent interrupt
/// may take the time that is left, but never the last look. Where the cycle count stands still it ends by the number of
/// its turns. Inlined, for as a call it costs more than what it waits for.
/// @return false when they have not by then
[[nodiscard, gnu::always_inline]] inline bool wait_within(const Register& status, std::uint32_t mask,
                                                          std::uint32_t value, std::uint32_t begin,
                                                          std::uint32_t limit) {
  constexpr std::uint32_t kTurn = 8;   // cycles, at least: two loads, of which one over a peripheral bus, and a branch
  constexpr std::uint32_t kLook = 20;  // cycles, of a look over APB1 and its way
  const WaitBound wait(limit);
  for (std::uint32_t turns = limit / kTurn; turns != 0 && cortex_m4::cycles() - begin + kLook < limit; --turns) {
    wait.pass();
    if ((status.read() & mask) == value) return true;
  }
  return (status.read() & mask) == value;
}

}  // namespace finemote::stm32f4
