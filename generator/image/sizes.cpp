#include "generator/image/sizes.hpp"

namespace finemote::gen {
namespace {

/// Below it stands what is mapped to address 0.
constexpr std::uint32_t kFlash = 0x08000000;

}  // namespace

ImageSizes measure_image(const Image& image) {
  ImageSizes sizes;
  for (const ImageSection& section : image.sections) {
    if (!section.allocated || section.size == 0) continue;
    sizes.sections.push_back({section.name, section.size});
    if (section.has_bytes) sizes.flash += section.size;
    if (section.has_bytes && !section.writable && section.address < kFlash) sizes.code_ram += section.size;
    if (section.writable && section.name != ".stack" && section.name != ".init_array") sizes.ram += section.size;
  }
  const ImageSymbol* bottom = image.find("_stack_bottom");
  const ImageSymbol* top = image.find("_stack_top");
  if (bottom != nullptr && top != nullptr && top->address > bottom->address) {
    sizes.stack_reserved = top->address - bottom->address;
  }
  return sizes;
}

std::uint32_t rounded_stack(std::uint32_t bytes) { return (bytes + 255) / 256 * 256; }

}  // namespace finemote::gen
