#include "emulator/core/tag.hpp"

namespace finemote::emulator {

WordTags moved(const WordTags& tags, int bits, Tag fill) {
  const auto at = [&](int byte) {
    if (byte < 0 || byte > 3) return fill;
    return tags[static_cast<std::size_t>(byte)];
  };
  WordTags result{};
  for (int i = 0; i < 4; ++i) {
    const int first = 8 * i - bits, last = first + 7;  // bits that come to byte `i`; a shift to the right rounds down
    result[static_cast<std::size_t>(i)] = newest(at(first >> 3), at(last >> 3));
  }
  return result;
}

WordTags turned(const WordTags& tags, unsigned bits) {
  WordTags result{};
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned first = 8 * i + bits, last = first + 7;
    result[i] = newest(tags[first / 8 % 4], tags[last / 8 % 4]);
  }
  return result;
}

}  // namespace finemote::emulator
