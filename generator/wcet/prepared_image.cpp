#include "generator/wcet/prepared_image.hpp"

#include <utility>

#include "generator/wcet/vectors.hpp"

namespace finemote::gen::wcet {
namespace {

std::vector<AddressRange> ranges_of(const std::vector<ImageRange>& kept) {
  std::vector<AddressRange> ranges;
  for (const ImageRange& range : kept) ranges.emplace_back(range.begin, range.end);
  return ranges;
}

}  // namespace

PreparedImage::PreparedImage(const Image& image, const KeptMembers& kept, CodeCost cost, Marks marks)
    : image_(image),
      marks_(std::move(marks)),
      program_(image, marks_.addresses()),
      cost_(cost),
      members_(ranges_of(kept.constant)),
      words_at_start_(words_set_at_start(kept)),
      constants_(image, members_, words_at_start_) {}

ImageFactsForWalk PreparedImage::facts(const Constants& constants, WordStores* stores, const Marks& marks) const {
  const ImageSymbol* top = image_.find("_stack_top");
  return {program_, constants, marks, cost_, stores, top == nullptr ? 0 : top->address};
}

/// Start-up is walked as any routine.
std::map<std::uint32_t, std::uint32_t> PreparedImage::words_set_at_start(const KeptMembers& kept) const {
  std::map<std::uint32_t, std::uint32_t> words;
  const auto start = start_of_buses(image_);
  if (!start || kept.at_start.empty()) return words;
  const Constants constants(image_, members_);
  WordStores stores;
  walk(facts(constants, &stores, marks_), *start);
  for (const ImageRange& range : kept.at_start) {
    for (std::uint32_t at = range.begin; at + 4 <= range.end; at += 4) {
      const auto stored = stores.find(at);
      if (stored != stores.end() && stored->second.is_constant()) words[at] = stored->second.low;
    }
  }
  return words;
}

}  // namespace finemote::gen::wcet
