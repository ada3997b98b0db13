#include "generator/wcet/memory_map.hpp"

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

struct Region {
  std::uint32_t first, last;
  Cycles MemoryWaits::*wait;
};

constexpr Region kFlashRegion = {0x08000000, 0x1FFFFFFF, &MemoryWaits::flash};  // system memory, too; CCM below
constexpr Region kElsewhere[] = {
    {0x20000000, 0x2001FFFF, &MemoryWaits::sram},           //
    {0x22000000, 0x23FFFFFF, &MemoryWaits::bit_band_sram},  // an alias of single bits, as below
    {0x40000000, 0x4000FFFF, &MemoryWaits::apb1},           //
    {0x40010000, 0x4001FFFF, &MemoryWaits::apb2},           //
    {0x40020000, 0x4007FFFF, &MemoryWaits::ahb},            //
    {0x42000000, 0x43FFFFFF, &MemoryWaits::bit_band_apb},   //
    {0x50000000, 0x5FFFFFFF, &MemoryWaits::ahb},            //
    {0xE0000000, 0xE00FFFFF, &MemoryWaits::own},
};
constexpr std::uint32_t kFirstDevice = 0x4000'0000, kLastMemory = 0xE00F'FFFF;
constexpr Interval kCoreRam{0x10000000, 0x1000FFFF};
constexpr Interval kLow{0x00000000, 0x07FFFFFF};
constexpr Interval kFlashMemory{0x08000000, 0x081FFFFF}, kSramMemory{0x20000000, 0x2001FFFF};

bool meets(Interval a, std::uint32_t first, std::uint32_t last) { return a.low <= last && first <= a.high; }

/// From below all peripherals to where nothing is: the address is unknown, or the number of an element is. No variable
/// and no array leads to a peripheral, then.
bool is_unknown(Interval address) { return address.low < kFirstDevice && address.high > kLastMemory; }

/// From below flash to core-coupled RAM or beyond: a pointer that may be none, say. It leads to no flash where the code
/// runs in SRAM.
bool spans_flash(Interval address) { return address.low < kFlashMemory.low && address.high >= kCoreRam.low; }

}  // namespace

std::optional<Cycles> longest_wait(Interval address, Placement placement, const MemoryWaits& waits) {
  if (kCoreRam.contains(address)) return 0;
  if (is_unknown(address))
    return std::max(longest_wait(kSramMemory, placement, waits),
                    longest_wait(placement == Placement::sram ? kLow : kFlashMemory, placement, waits));
  std::optional<Cycles> longest;
  if (meets(address, kLow.low, kLow.high)) longest = placement == Placement::sram ? waits.fetched_sram : waits.flash;
  const auto take = [&](const Region& region) {
    if (meets(address, region.first, region.last)) longest = std::max(longest.value_or(0), waits.*region.wait);
  };
  if (placement == Placement::flash || !spans_flash(address)) take(kFlashRegion);
  for (const Region& region : kElsewhere) take(region);
  return longest;
}

std::optional<Interval> where_unaligned(Interval address) {
  return is_unknown(address) ? address : meet(address, Interval{0, kFirstDevice - 1});
}

}  // namespace finemote::gen::wcet
