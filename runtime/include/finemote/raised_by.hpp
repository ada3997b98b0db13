// Places in the routines of buses that only some interrupts lead to: docs/wcet.md.
#pragma once

#include <cstdint>

namespace finemote {

/// What raises an interrupt of a bus, as the sources of schemas/chips count them.
enum class Raised : std::uint32_t {
  request = 1,   ///< a stage or flush asks for a transfer, or a supervisor for attention
  step = 2,      ///< a part of a transfer is over, and more is to come
  end = 4,       ///< a transfer is over
  received = 8,  ///< a frame or a buffer of bytes came in
  event = 16,    ///< something happened on the line: it fell silent, or a byte was damaged
};

/// This place is passed only by runs of a routine that one of `causes` raised. It costs no instruction; tools leave the
/// ways through it out of the times of the others. What is told must be true: nothing checks it.
template <Raised... causes>
[[gnu::always_inline]] inline void only_if_raised_by() {
#ifdef __arm__
  asm volatile inline("0: .pushsection .debug_finemote_raised,\"\",%%progbits\n\t.word 0b, %c0\n\t.popsection" ::"i"(
      (static_cast<std::uint32_t>(causes) | ...)));
#endif
}

}  // namespace finemote
