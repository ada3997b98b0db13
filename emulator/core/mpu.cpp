#include "emulator/core/mpu.hpp"

#include <algorithm>

namespace finemote::emulator {
namespace {

constexpr std::uint32_t kType = 0xE000ED90, kControl = 0xE000ED94, kNumber = 0xE000ED98, kBase = 0xE000ED9C,
                        kEnd = 0xE000EDBC;
constexpr unsigned kParts = 8;
constexpr std::uint64_t kSmallestInParts = 256;

/// AP of privileged code: nobody; only to read. PM0214 4.2.10.
constexpr std::uint32_t kNoAccess = 0, kReadOnly = 5, kReadOnlyForAll = 6, kReadOnlyAlso = 7;

}  // namespace

bool MpuRegion::covers(std::uint32_t address) const {
  const std::uint64_t offset = std::uint64_t{address} - base;
  if (!enabled() || address < base || offset >= bytes()) return false;
  return bytes() < kSmallestInParts || (attributes >> (8 + offset * kParts / bytes()) & 1) == 0;
}

std::optional<std::uint32_t> Mpu::read(std::uint32_t address) const {
  if (address == kType) return 8U << 8;  // eight regions
  if (address == kControl) return control_;
  if (address == kNumber) return number_;
  if (address < kBase || address >= kEnd) return std::nullopt;
  const MpuRegion& region = regions_[number_ & 7];
  return (address & 4) == 0 ? region.attributes : (region.base | (number_ & 7));
}

bool Mpu::write(std::uint32_t address, std::uint32_t value) {
  if (address == kControl) {
    control_ = value & 7;
  } else if (address == kNumber) {
    number_ = value & 0xFF;
  } else if (address < kBase || address >= kEnd) {
    return false;
  } else if ((address & 4) != 0) {  // RBAR: 0xE000ED9C, +8 ...
    if ((value & 0x10) != 0) number_ = value & 0xF;
    regions_[number_ & 7].base = value & ~0x1FU;
  } else {
    regions_[number_ & 7].attributes = value;
  }
  return true;
}

/// Where several do, the one with the highest number counts: B3.5.3. Null: none.
const MpuRegion* Mpu::region_at(std::uint32_t address) const {
  const auto found = std::find_if(regions_.rbegin(), regions_.rend(),
                                  [address](const MpuRegion& region) { return region.covers(address); });
  return found == regions_.rend() ? nullptr : &*found;
}

bool Mpu::may_write(std::uint32_t address) const {
  if (!is_on()) return true;
  const MpuRegion* region = region_at(address);
  if (region == nullptr) return has_background();
  switch (region->access()) {
    case kNoAccess:
    case kReadOnly:
    case kReadOnlyForAll:
    case kReadOnlyAlso:
      return false;
    default:
      return true;
  }
}

bool Mpu::may_execute(std::uint32_t address) const {
  if (!is_on()) return true;
  const MpuRegion* region = region_at(address);
  if (region == nullptr) return has_background();
  return region->access() != kNoAccess && !region->execute_never();
}

/// What holds at each of them holds up to the next.
std::vector<std::uint32_t> Mpu::borders(std::uint32_t address, std::uint32_t bytes) const {
  std::vector<std::uint32_t> borders{address};
  for (const MpuRegion& region : regions_) {
    for (unsigned part = 0; region.enabled() && part <= kParts; ++part) {
      const std::uint64_t at = region.base + region.bytes() * part / kParts;
      if (at > address && at - address < bytes) borders.push_back(static_cast<std::uint32_t>(at));
    }
  }
  std::sort(borders.begin(), borders.end());
  return borders;
}

bool Mpu::may_execute(std::uint32_t address, std::uint32_t bytes) const {
  const std::vector<std::uint32_t> all = borders(address, bytes);
  return std::all_of(all.begin(), all.end(), [this](std::uint32_t at) { return may_execute(at); });
}

std::uint32_t Mpu::end_of_protected(std::uint32_t address, std::uint32_t bytes) const {
  const std::vector<std::uint32_t> all = borders(address, bytes);
  std::uint32_t end = address + bytes;
  for (auto at = all.rbegin(); at != all.rend(); ++at) {
    if (!may_write(*at)) return end;
    end = *at;
  }
  return address;
}

std::pair<std::uint32_t, std::uint32_t> Mpu::guard() const {
  if (!is_on()) return {0, 0};
  for (const MpuRegion& region : regions_) {
    if (region.enabled() && region.access() == kNoAccess && region.base >= 0x10000000U && region.base < 0x40000000U)
      return {region.base, region.base + static_cast<std::uint32_t>(region.bytes())};
  }
  return {0, 0};
}

}  // namespace finemote::emulator
