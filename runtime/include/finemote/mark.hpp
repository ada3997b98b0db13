// Places in the code that tools know of and that cost no instruction: where a stage or a part of the runtime's own work
// begins and ends.
#pragma once

#include <cstdint>

#include "finemote/assembler.hpp"

namespace finemote {

/// Records the address of this place and `number` in section `.debug_finemote`, two words each. Tools read it; it is no
/// part of what is flashed. No access to memory is moved across it. On a computer it does nothing.
template <std::uint32_t number>
[[gnu::always_inline]] inline void mark() {
  FINEMOTE_ASM("0:" FINEMOTE_FOR_TOOLS(".debug_finemote", ".word 0b, %c0")::"i"(number) : "memory");
}

/// Marks its scope: `number`, and one more at the end. Numbers are even.
template <std::uint32_t number>
class Marked {
 public:
  Marked() { mark<number>(); }
  ~Marked() { mark<number + 1U>(); }
  Marked(const Marked&) = delete;
  Marked& operator=(const Marked&) = delete;
};

/// What the runtime does beside stages. The values are known to whoever measures: they do not change.
enum class Work : std::uint32_t {
  supervise_i2c,
  supervise_spi,
  supervise_can,
  supervise_rs485,
  flush_pwm,
  flush_expander,
  flush_can,
  masked,     ///< interrupts are kept out
  hand_over,  ///< a driver is given something to send: only the begin
};

/// Marks of stages are below it: 65536 stages have two each, and each of these begin and end.
constexpr std::uint32_t kFirstWorkMark = 0x40000;

/// Of the handle() that runs here tools expect an output from now on: of it, or of a later run.
[[gnu::always_inline]] inline void mark_hand_over() {
  mark<kFirstWorkMark + 2U * static_cast<std::uint32_t>(Work::hand_over)>();
}

template <Work work>
using MarkedWork = Marked<kFirstWorkMark + 2U * static_cast<std::uint32_t>(work)>;

}  // namespace finemote
