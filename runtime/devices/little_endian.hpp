// Turns bytes of which the first is the lowest into numbers, and numbers into such bytes, wherever they lie.
#pragma once

#include <cstdint>

#include "finemote/four_bytes.hpp"

namespace finemote {

[[gnu::always_inline]] inline std::uint16_t uint16_at(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}

[[gnu::always_inline]] inline std::int16_t int16_at(const std::uint8_t* bytes) {
  return static_cast<std::int16_t>(uint16_at(bytes));
}

[[gnu::always_inline]] inline std::uint32_t uint24_at(const std::uint8_t* bytes) {
  return uint16_at(bytes) | std::uint32_t{bytes[2]} << 16;
}

[[gnu::always_inline]] inline std::int32_t int32_at(const std::uint8_t* bytes) {
  return static_cast<std::int32_t>(four_bytes(bytes));
}

/// From bit `at` on, the lowest first: of three bytes.
[[gnu::always_inline]] inline std::uint16_t eleven_bits_at(const std::uint8_t* bytes, unsigned at) {
  return static_cast<std::uint16_t>(uint24_at(bytes + at / 8) >> at % 8 & 0x7FFU);
}

/// As the processor keeps it.
[[gnu::always_inline]] inline void put_uint16(std::uint16_t value, std::uint8_t* bytes) {
  __builtin_memcpy(bytes, &value, sizeof value);
}

[[gnu::always_inline]] inline void put_uint32(std::uint32_t value, std::uint8_t* bytes) {
  __builtin_memcpy(bytes, &value, sizeof value);
}

}  // namespace finemote
