// The bit-band aliases: each of their words is one bit of the RAM or of a peripheral. PM0214 2.2.5.
#pragma once

#include <cstdint>
#include <optional>

#include "emulator/core/address_map.hpp"

namespace finemote::emulator {

/// Where the bit of an alias lies.
struct BandedBit {
  std::uint32_t address;  ///< what is read and, with the bit changed, written back; aligned to the size of the access
  unsigned bit;
};

/// @param bytes  of the access to the alias, and so of that to what it stands for
/// @return nothing: the address is no alias
inline std::optional<BandedBit> banded_bit(std::uint32_t address, unsigned bytes) {
  constexpr std::uint32_t kAlias = 0x02000000, kMegabyte = 0x100000;
  for (const std::uint32_t region : {0x40000000U, 0x20000000U}) {
    if (!lies_in(address, region + kAlias, 32 * kMegabyte)) continue;
    const std::uint32_t place = address - region - kAlias, byte = place / 32;
    const std::uint32_t first = byte & ~(bytes - 1);
    return BandedBit{region + first, 8 * (byte - first) + place / 4 % 8};
  }
  return std::nullopt;
}

}  // namespace finemote::emulator
