// A text to a number that tells it from other texts.
#pragma once

#include <cstdint>
#include <string_view>

namespace finemote::gen {

/// 64-bit FNV-1a: no accident gives two texts one digest; who wants to can.
constexpr std::uint64_t digest(std::string_view text) {
  std::uint64_t value = 14695981039346656037U;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return value;
}

}  // namespace finemote::gen
