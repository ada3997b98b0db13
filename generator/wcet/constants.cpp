#include "generator/wcet/constants.hpp"

#include <algorithm>

namespace finemote::gen::wcet {
namespace {

/// Tables that are larger are not looked through.
constexpr std::uint32_t kLargestTable = 1024;

/// In order, those that touch or lie in each other as one.
std::vector<AddressRange> merged(std::vector<AddressRange> ranges) {
  std::sort(ranges.begin(), ranges.end());
  std::vector<AddressRange> whole;
  for (const AddressRange& range : ranges) {
    if (whole.empty() || whole.back().second < range.first)
      whole.push_back(range);
    else
      whole.back().second = std::max(whole.back().second, range.second);
  }
  return whole;
}

}  // namespace

bool is_zeroed(const Image& image, std::uint32_t address, std::uint32_t size) {
  return std::any_of(image.sections.begin(), image.sections.end(),
                     [&](const ImageSection& section) { return section.is_zeroed() && section.holds(address, size); });
}

Constants::Constants(const Image& image, std::vector<AddressRange> members,
                     std::map<std::uint32_t, std::uint32_t> words)
    : image_(image), ranges_(std::move(members)), words_(std::move(words)) {
  for (const ImageSection& section : image.sections) {
    if (section.allocated && section.has_bytes && !section.writable)
      ranges_.emplace_back(section.address, section.address + section.size);
  }
  ranges_ = merged(std::move(ranges_));
}

bool Constants::is_constant(std::uint32_t address, std::uint32_t size) const {
  auto range = std::upper_bound(ranges_.begin(), ranges_.end(), AddressRange{address, UINT32_MAX});
  return range != ranges_.begin() && address + size <= std::prev(range)->second;
}

std::optional<std::uint32_t> Constants::word(std::uint32_t address, std::uint32_t size) const {
  const auto set = words_.find(address);
  if (set != words_.end() && size == 4) return set->second;
  if (!is_constant(address, size)) return std::nullopt;
  if (is_zeroed(image_, address, size)) return 0;
  const std::string_view bytes = image_.bytes(address, size);
  if (bytes.size() < size) return std::nullopt;
  std::uint32_t value = 0;
  for (std::uint32_t i = size; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

bool Constants::is_broken_by(const Access& store) const {
  const Interval at = store.address.range();
  return at.is_constant() && is_constant(at.low, store.size);
}

/// Only a table's step says that what is read lies at a multiple of its size: parts of packed classes do not.
std::optional<Interval> Constants::load(const Access& access) const {
  const Interval at = access.address.range();
  if (at.high - at.low > kLargestTable) return std::nullopt;
  std::optional<Interval> result;
  for (std::uint64_t address = at.low; address <= at.high; address += access.step) {
    const auto value = word(static_cast<std::uint32_t>(address), access.size);
    if (!value) return std::nullopt;
    result = result ? join(*result, Interval::of(*value)) : Interval::of(*value);
  }
  return result;
}

}  // namespace finemote::gen::wcet
