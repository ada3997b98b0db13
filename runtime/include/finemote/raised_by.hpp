// Places in the routines of buses that only some interrupts lead to: docs/wcet.md.
#pragma once

#include <cstdint>

#include "finemote/assembler.hpp"

namespace finemote {

/// What raises an interrupt of a bus, as the sources of schemas/chips count them.
enum class Raised : std::uint32_t {
  request = 1,   ///< a stage or flush asks for a transfer, or a supervisor for attention
  step = 2,      ///< a part of a transfer is over, and more is to come
  end = 4,       ///< a transfer is over
  received = 8,  ///< a frame or a buffer of bytes came in
  event = 16,    ///< something happened on the line: it fell silent, or a byte was damaged
};

namespace detail {

constexpr std::uint32_t kOnceForEach = 0x8000'0000;

/// Records the address of this place and `word` in section `.debug_finemote_raised`, two words each.
template <std::uint32_t word>
[[gnu::always_inline]] inline void tell_raised() {
  FINEMOTE_ASM("0:" FINEMOTE_FOR_TOOLS(".debug_finemote_raised", ".word 0b, %c0")::"i"(word));
}

}  // namespace detail

/// This place is passed only by runs of a routine that one of `causes` raised. It costs no instruction; tools leave the
/// ways through it out of the times of the others. What is told must be true: nothing checks it.
template <Raised... causes>
[[gnu::always_inline]] inline void only_if_raised_by() {
  detail::tell_raised<(static_cast<std::uint32_t>(causes) | ...)>();
}

/// This place, in the body of a loop, is passed once for each interrupt that `cause` raises, whichever run passes it: a
/// run that finds two frames serves the interrupts of both. It costs no instruction; tools charge each interrupt one
/// round, and the way around the loop. What is told must be true: nothing checks it.
template <Raised cause>
[[gnu::always_inline]] inline void once_for_each() {
  detail::tell_raised<detail::kOnceForEach | static_cast<std::uint32_t>(cause)>();
}

}  // namespace finemote
