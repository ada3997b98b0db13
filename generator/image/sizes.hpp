// How much flash and RAM an image takes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/image/image.hpp"

namespace finemote::gen {

struct SectionSize {
  std::string name;
  std::uint32_t size = 0;
};

/// Bytes.
struct ImageSizes {
  std::uint32_t flash = 0;            ///< vectors, code, constants and initial values
  std::uint32_t ram = 0;              ///< variables and buffers, without the stack
  std::uint32_t code_ram = 0;         ///< vectors, code and constants that are copied to RAM to run there
  std::uint32_t stack_reserved = 0;   ///< between `_stack_bottom` and `_stack_top`
  std::vector<SectionSize> sections;  ///< allocated ones that are not empty, in address order of the file
};

ImageSizes measure_image(const Image& image);

/// What to reserve for a stack of `bytes`: a little more, so that a small change does not need another figure.
std::uint32_t rounded_stack(std::uint32_t bytes);

}  // namespace finemote::gen
