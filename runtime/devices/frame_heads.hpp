// Finds the places in some bytes at which frames may begin.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/loop_bound.hpp"

namespace finemote {

/// Of at most `most` bytes: which are the first of two that every frame begins with. The last byte may be the first of
/// them alone. Looking for them takes a time that grows with the bytes, whatever they are, and asking for the next one
/// a fixed one.
template <std::size_t most>
class FrameHeads {
 public:
  static constexpr std::size_t kNone = most;  ///< there is no further place

  FrameHeads(const std::uint8_t* bytes, std::size_t size, std::uint8_t first, std::uint8_t second) {
    const std::uint32_t head = std::uint32_t{first} << 8 | second;
    std::uint32_t pair = 0;
    for (std::size_t word = 0, left = size; word < kWords && left != 0; ++word) {
      const std::size_t count = left < kBits ? left : kBits;
      left -= count;
      words_[word] = seconds(bytes, count, head, pair) << (kBits - count);
      bytes += count;
    }
    if ((pair & 0xFFU) == first && size != 0) last_ = size - 1;
  }

  /// The first place at `from` or behind it.
  [[nodiscard]] std::size_t next(std::size_t from) const {
    const std::size_t second = from + 1;
    std::uint32_t wanted = UINT32_MAX >> second % kBits;
    for (std::size_t word = second / kBits; word < kWords; ++word) {
      const std::uint32_t left = words_[word] & wanted;
      if (left != 0) return kBits * word + static_cast<std::size_t>(__builtin_clz(left)) - 1;
      wanted = UINT32_MAX;
    }
    return from <= last_ ? last_ : kNone;
  }

 private:
  static constexpr std::size_t kBits = 32, kWords = (most + kBits - 1) / kBits;

  /// Which of some bytes are the second of a head, the last one's bit lowest. `pair` are the two before them, and then
  /// the last two.
  static std::uint32_t seconds(const std::uint8_t* bytes, std::size_t count, std::uint32_t head, std::uint32_t& pair) {
    std::uint32_t bits = 0;
    for (; count != 0; --count) {
      as_counted(count);
      pair = (pair << 8 | *bytes++) & 0xFFFFU;
      bits = bits << 1 | (pair == head ? 1U : 0U);
    }
    return bits;
  }

  std::uint32_t words_[kWords]{};  ///< a bit for every byte, the highest of a word first: it is the second of a head
  std::size_t last_ = kNone;       ///< the last byte, where it is the first of a head
};

}  // namespace finemote
