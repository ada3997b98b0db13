#include "generator/image/flashed.hpp"

#include <elf.h>

#include <algorithm>
#include <cstring>

namespace finemote::gen {
namespace {

/// The headers of segments with bytes, by their place. A file that read_image accepts has an ELF header; what its
/// program headers say may still be nonsense.
std::vector<Elf32_Phdr> loaded_segments(const std::vector<char>& file) {
  Elf32_Ehdr header;
  std::memcpy(&header, file.data(), sizeof header);
  std::vector<Elf32_Phdr> segments;
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const std::size_t at = header.e_phoff + i * sizeof(Elf32_Phdr);
    if (at + sizeof(Elf32_Phdr) > file.size()) break;
    Elf32_Phdr segment;
    std::memcpy(&segment, file.data() + at, sizeof segment);
    const bool is_inside = std::uint64_t{segment.p_offset} + segment.p_filesz <= file.size();
    if (segment.p_type == PT_LOAD && segment.p_filesz > 0 && is_inside) segments.push_back(segment);
  }
  std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) { return a.p_paddr < b.p_paddr; });
  return segments;
}

}  // namespace

std::string flashed_bytes(const Image& image) {
  constexpr std::uint32_t kLargestGap = 1U << 20;  // the whole flash
  std::string bytes;
  std::uint32_t end = 0;
  for (const Elf32_Phdr& segment : loaded_segments(image.file)) {
    const std::uint32_t gap = bytes.empty() || segment.p_paddr < end ? 0 : segment.p_paddr - end;
    bytes.append(std::min(gap, kLargestGap), '\0');
    bytes.append(image.file.data() + segment.p_offset, segment.p_filesz);
    end = segment.p_paddr + segment.p_filesz;
  }
  return bytes;
}

}  // namespace finemote::gen
