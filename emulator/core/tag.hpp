// Tags say where a byte comes from: beside its value, wherever it goes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace finemote::emulator {

/// A number of a list of origins (emulator/core/provenance.hpp): what is newer has the larger one.
enum class Tag : std::uint32_t { none };

/// Tags of a word, its lowest byte first.
using WordTags = std::array<Tag, 4>;

inline Tag newest(Tag a, Tag b) { return std::max(a, b); }
inline Tag newest(const WordTags& tags) { return newest(newest(tags[0], tags[1]), newest(tags[2], tags[3])); }
/// Byte by byte.
inline WordTags newer(const WordTags& a, const WordTags& b) {
  return {newest(a[0], b[0]), newest(a[1], b[1]), newest(a[2], b[2]), newest(a[3], b[3])};
}
inline WordTags all_of(Tag tag) { return {tag, tag, tag, tag}; }
/// Looked at together: this is asked at every instruction.
template <class... Words>
bool is_untagged(const Words&... words) {
  std::uint64_t any = 0;
  const auto look = [&any](const WordTags& tags) {
    std::array<std::uint64_t, 2> halves;
    static_assert(sizeof halves == sizeof tags);
    std::memcpy(halves.data(), tags.data(), sizeof halves);
    any |= halves[0] | halves[1];
  };
  (look(words), ...);
  return any == 0;
}

/// Tags of a word whose bits are moved by `bits`, up where it is positive; where bits of two bytes meet, the newer
/// one's. What comes in is `fill`.
WordTags moved(const WordTags& tags, int bits, Tag fill = Tag::none);
/// The same, around: to the right.
WordTags turned(const WordTags& tags, unsigned bits);

/// A byte on its way over a line, with where it comes from.
struct WireByte {
  std::uint8_t value = 0;
  Tag tag = Tag::none;

  WireByte() = default;
  WireByte(std::uint8_t byte, Tag from = Tag::none) : value(byte), tag(from) {}  // NOLINT: a byte of unknown origin
  operator std::uint8_t() const { return value; }  // NOLINT: to whom the origin is nothing
  /// Both drive one line, which they can only pull low.
  WireByte& operator&=(WireByte other) {
    value &= other.value;
    tag = newest(tag, other.tag);
    return *this;
  }
};

}  // namespace finemote::emulator
