// Says what of a robot goes over a link to a computer, and how a frame of it is made.
//
// The generator writes the tables, and for the computer a header that makes and reads the same frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "finemote/contract.hpp"

namespace finemote {

/// How a value is written: little endian, two's complement, IEEE 754; a boolean is one byte, 0 or 1.
enum class LinkKind : std::uint8_t { kBool, kU8, kI16, kU16, kI32, kU32, kF32, kI64 };

/// One value that goes up.
struct LinkField {
  LinkKind kind;
  const void* from;
};

/// One value that comes down.
struct LinkSlot {
  LinkKind kind;
  void* to;
};

/// Kind of a C++ type; an enumeration goes as its number. Types a frame cannot carry do not compile.
template <class T>
constexpr LinkKind link_kind() {
  using U = typename std::conditional_t<std::is_enum_v<T>, std::underlying_type<T>, std::enable_if<true, T>>::type;
  if constexpr (std::is_same_v<U, bool>) {
    return LinkKind::kBool;
  } else if constexpr (std::is_floating_point_v<U>) {
    static_assert(sizeof(U) == 4, "a link carries float, not double");
    return LinkKind::kF32;
  } else {
    static_assert(std::is_integral_v<U> && (sizeof(U) < 8 || std::is_signed_v<U>), "a link cannot carry this type");
    static_assert(sizeof(U) > 1 || std::is_unsigned_v<U>, "a link cannot carry this type");
    if constexpr (sizeof(U) == 1) return LinkKind::kU8;
    if constexpr (sizeof(U) == 2) return std::is_signed_v<U> ? LinkKind::kI16 : LinkKind::kU16;
    if constexpr (sizeof(U) == 4) return std::is_signed_v<U> ? LinkKind::kI32 : LinkKind::kU32;
    return LinkKind::kI64;
  }
}

/// `Expected` is the kind the generator wrote into the computer's header: another one here does not compile.
template <LinkKind Expected, class T>
constexpr LinkField link_up(const T& value) {
  static_assert(link_kind<T>() == Expected, "the interface table and the C++ type differ");
  return {Expected, &value};
}
template <LinkKind Expected, class T>
constexpr LinkSlot link_down(T& value) {
  static_assert(link_kind<T>() == Expected, "the interface table and the C++ type differ");
  return {Expected, &value};
}

/// The state of one device: origin and validity, then its fields.
struct LinkSource {
  const Stamp& stamp;
  View<LinkField> fields;
  std::uint8_t block;  ///< of the frames it goes in
};

/// The command of one device: validity, then its fields. Its origin is when the frame arrived.
struct LinkTarget {
  Stamp& stamp;
  View<LinkSlot> fields;
  std::uint8_t block;
};

/// All of it. A layout that differs in anything has another number.
struct LinkLayout {
  std::uint32_t number;
  View<LinkSource> up;
  View<LinkTarget> down;
  std::uint8_t up_blocks, down_blocks;
};

/// A frame: 0xA5 0x5A, kind (high nibble) and block, size of the payload, layout (4), sequence, payload, CRC (2) over
/// all but the first two bytes.
namespace link {
inline constexpr std::uint8_t kFirst = 0xA5, kSecond = 0x5A;
inline constexpr std::uint8_t kStates = 1, kCommands = 2;
inline constexpr std::size_t kHeader = 9, kCrc = 2, kMaxPayload = 117;
inline constexpr std::size_t kMaxFrame = kHeader + kMaxPayload + kCrc;  ///< 128
inline constexpr std::size_t kMaxBlocks = 16;                           ///< each way

/// Bytes of a value.
constexpr std::size_t size_of(LinkKind kind) {
  switch (kind) {
    case LinkKind::kBool:
    case LinkKind::kU8:
      return 1;
    case LinkKind::kI16:
    case LinkKind::kU16:
      return 2;
    case LinkKind::kI32:
    case LinkKind::kU32:
    case LinkKind::kF32:
      return 4;
    case LinkKind::kI64:
      return 8;
  }
  return 0;
}

/// Bytes of a device's command.
constexpr std::size_t size_of(const LinkTarget& target) {
  std::size_t size = 1;
  for (const LinkSlot& field : target.fields) size += size_of(field.kind);
  return size;
}

/// CRC-16/IBM-3740: polynomial 0x1021, from 0xFFFF, nothing reflected; of "123456789" it is 0x29B1.
std::uint16_t crc(const std::uint8_t* bytes, std::size_t size);
}  // namespace link

}  // namespace finemote
