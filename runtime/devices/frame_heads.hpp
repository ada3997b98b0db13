// Finds the places in some bytes at which frames may begin.
#pragma once

#include <cstddef>
#include <cstdint>

#include "finemote/four_bytes.hpp"
#include "finemote/least.hpp"
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
    Search search{bytes, first * kOnes, second * kOnes};
    const std::size_t whole = least(size, most) / kBits, rest = size % kBits;
    for (std::size_t word = 0; word < whole; ++word) words_[word] = search.fours(kBits / 4);
    if (rest != 0 && whole < kWords) words_[whole] = search.next(rest) << (kBits - rest);
    if (search.ends_with_first() && size != 0) last_ = size - 1;
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

  static constexpr std::uint32_t kOnes = 0x01010101, kLow = 0x7F7F7F7F;

  /// Looks at four bytes at a time.
  struct Search {
    const std::uint8_t* bytes;
    std::uint32_t firsts, seconds;          ///< four times
    std::uint32_t before = ~firsts << 24U;  ///< the highest byte is the one before `bytes`

    /// Which of the next bytes are the second of a head, the last one's bit lowest.
    std::uint32_t next(std::size_t count) {
      std::uint32_t bits = fours(count / 4);
      for (std::size_t rest = count % 4; rest != 0; --rest) {
        as_counted(rest);
        const std::uint32_t byte = *bytes++;
        bits = bits << 1 | (byte == (seconds & 0xFFU) && ends_with_first() ? 1U : 0U);
        before = byte << 24;
      }
      return bits;
    }
    /// The same of four times as many.
    std::uint32_t fours(std::size_t count) {
      const std::uint8_t* from = bytes;
      std::uint32_t last = before, bits = 0;
      const std::uint32_t first = firsts, second = seconds;  // not read anew, as behind an access to bytes
      for (; count != 0; --count) {
        as_counted(count);
        const std::uint32_t four = four_bytes(from);
        bits = bits << 4 | zeros((four ^ second) | ((four << 8 | last >> 24) ^ first));
        last = four;
        from += 4;
      }
      bytes = from;
      before = last;
      return bits;
    }
    [[nodiscard]] bool ends_with_first() const { return before >> 24 == (firsts & 0xFFU); }

    /// A bit for each byte that is 0, the lowest byte's highest of four.
    static std::uint32_t zeros(std::uint32_t four) {
      const std::uint32_t highest = ~(((four & kLow) + kLow) | four | kLow);  // the highest bit of each such byte
      constexpr std::uint32_t kGather = 1U << 27 | 1U << 18 | 1U << 9 | 1U;   // to bits 27 to 24, without a carry
      return (highest >> 7) * kGather >> 24 & 0xFU;
    }
  };

  std::uint32_t words_[kWords]{};  ///< a bit for every byte, the highest of a word first: it is the second of a head
  std::size_t last_ = kNone;       ///< the last byte, where it is the first of a head
};

}  // namespace finemote
