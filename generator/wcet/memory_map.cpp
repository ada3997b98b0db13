#include "generator/wcet/memory_map.hpp"

#include <algorithm>
#include <iterator>

namespace finemote::gen::wcet {
namespace {

struct Region {
  std::uint32_t first, last;
  Cycles wait;
  bool is_alias = false;  ///< of single bits: no pointer of C++ leads there, only a constant address
};

// Flash: the five wait states of a line, and one read in flight before it, which cannot be taken back.
constexpr Cycles kFlash = 5 + 6;
constexpr Cycles kFetchedSram = 2;  // the fetch of the code goes to the same memory
constexpr Cycles kSram = 1;         // arbitration of the matrix
constexpr Cycles kAhb = 2;          // arbitration and transfer
constexpr Cycles kApb2 = 8;         // 84 MHz: alignment, bridge and two of its cycles
constexpr Cycles kApb1 = 14;        // 42 MHz: the same
constexpr Cycles kPrivate = 2;      // of the core's own bus no figure is documented: assumed
constexpr Cycles kBitBandSram = 2 * (kSram + 1), kBitBandApb = 2 * (kApb1 + 1);  // read, changed and written

constexpr Region kElsewhere[] = {
    {0x08000000, 0x1FFFFFFF, kFlash},  // flash, system memory; CCM below
    {0x20000000, 0x2001FFFF, kSram},   //
    {0x22000000, 0x23FFFFFF, kBitBandSram, true},
    {0x40000000, 0x4000FFFF, kApb1},
    {0x40010000, 0x4001FFFF, kApb2},
    {0x40020000, 0x4007FFFF, kAhb},
    {0x42000000, 0x43FFFFFF, kBitBandApb, true},
    {0x50000000, 0x5FFFFFFF, kAhb},
    {0xE0000000, 0xE00FFFFF, kPrivate},
};
constexpr Interval kCoreRam{0x10000000, 0x1000FFFF};
constexpr Interval kLow{0x00000000, 0x07FFFFFF};
constexpr Interval kFlashMemory{0x08000000, 0x081FFFFF}, kSramMemory{0x20000000, 0x2001FFFF};

bool meets(Interval a, std::uint32_t first, std::uint32_t last) { return a.low <= last && first <= a.high; }

}  // namespace

Cycles longest_wait(Interval address, Placement placement) {
  if (kCoreRam.contains(address)) return 0;
  if (address == Interval::any())
    return std::max(longest_wait(kSramMemory, placement),
                    longest_wait(placement == Placement::sram ? kLow : kFlashMemory, placement));
  Cycles longest = 0;
  if (meets(address, kLow.low, kLow.high)) longest = placement == Placement::sram ? kFetchedSram : kFlash;
  for (const Region& region : kElsewhere) {
    if (region.is_alias && !address.is_constant()) continue;
    if (meets(address, region.first, region.last)) longest = std::max(longest, region.wait);
  }
  return longest;
}

}  // namespace finemote::gen::wcet
