// Moves bytes four at a time, wherever they lie: a byte alone costs as much as four.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/loop_bound.hpp"

namespace finemote {

/// The first byte is the lowest.
[[gnu::always_inline]] inline std::uint32_t four_bytes(const std::uint8_t* from) {
  std::uint32_t four;
  __builtin_memcpy(&four, from, sizeof four);
  return four;
}

[[gnu::always_inline]] inline void move_four(const std::uint8_t* from, std::uint8_t* to) {
  const std::uint32_t four = four_bytes(from);
  __builtin_memcpy(to, &four, sizeof four);
}

/// To lower addresses where they overlap.
inline void move_bytes(const std::uint8_t* from, std::uint8_t* to, std::size_t size) {
  for (std::size_t fours = size / 4; fours != 0; --fours) {
    as_counted(fours);
    move_four(from, to);
    from += 4;
    to += 4;
  }
  for (std::size_t rest = size % 4; rest != 0; --rest) {
    as_counted(rest);
    *to++ = *from++;
  }
}

}  // namespace finemote
