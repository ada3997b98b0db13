#include "generator/wcet/prepared_image.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "generator/wcet/vectors.hpp"

namespace finemote::gen::wcet {
namespace {

/// Something is constructed when the program runs.
bool has_constructors(const Image& image) {
  return std::any_of(image.sections.begin(), image.sections.end(), [](const ImageSection& section) {
    return section.name.rfind(".init_array", 0) == 0 && section.size > 0;
  });
}

/// Its first value is known.
bool is_filled(const Image& image, const ImageRange& range) {
  return std::any_of(image.sections.begin(), image.sections.end(), [&](const ImageSection& section) {
    return section.is_filled() && section.holds(range.begin, range.end - range.begin);
  });
}

/// In whatever section.
bool is_zero(const Image& image, const ImageRange& range) {
  const std::uint32_t size = range.end - range.begin;
  const std::string_view bytes = image.bytes(range.begin, size);
  return is_zeroed(image, range.begin, size) || bytes.find_first_not_of('\0') == std::string_view::npos;
}

/// What is constructed when the program runs is zero in the image, beside parts of the same variable that are not: of
/// that, and of variables in functions, which may be constructed when they are first reached, only those with another
/// initial value are constants.
std::vector<AddressRange> constants_of(const Image& image, const KeptMembers& kept) {
  std::vector<AddressRange> ranges;
  const bool is_constructed = has_constructors(image);
  const auto add = [&](const std::vector<ImageRange>& all, bool may_be_set_later) {
    for (const ImageRange& range : all) {
      if (is_filled(image, range) && (!may_be_set_later || !is_zero(image, range)))
        ranges.emplace_back(range.begin, range.end);
    }
  };
  add(kept.constant, is_constructed);
  add(kept.constant_in_functions, true);
  return ranges;
}

}  // namespace

PreparedImage::PreparedImage(const Image& image, const KeptMembers& kept, CodeCost cost, Marks marks)
    : image_(image),
      marks_(std::move(marks)),
      program_(image, marks_.addresses()),
      cost_(cost),
      members_(constants_of(image, kept)),
      words_at_start_(words_set_at_start(kept)),
      constants_(image, members_, words_at_start_) {}

WalkContext PreparedImage::context(const Constants& constants, WordStores* stores, const Marks& marks) const {
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
  walk(context(constants, &stores, marks_), *start);
  for (const ImageRange& range : kept.at_start) {
    for (std::uint32_t at = range.begin; at + 4 <= range.end; at += 4) {
      const auto stored = stores.find(at);
      if (stored != stores.end() && stored->second.is_constant()) words[at] = stored->second.low;
    }
  }
  return words;
}

}  // namespace finemote::gen::wcet
