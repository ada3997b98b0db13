#include "generator/report/base64.hpp"

#include <cstdint>

namespace finemote::gen::report {

std::string base64_of_hex(std::string_view digits) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  std::uint32_t bits = 0;
  unsigned held = 0;
  for (const char digit : digits) {
    bits = bits << 4 | static_cast<std::uint32_t>(kHex.find(digit));
    held += 4;
    if (held < 6) continue;
    held -= 6;
    out += kAlphabet[bits >> held & 63];
  }
  if (held > 0) out += kAlphabet[bits << (6 - held) & 63];
  while (out.size() % 4 != 0) out += '=';
  return out;
}

}  // namespace finemote::gen::report
