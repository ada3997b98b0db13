#include "emulator/core/image.hpp"

#include <elf.h>

#include <algorithm>

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "emulator/core/intel_hex.hpp"
#include "emulator/core/memories.hpp"

namespace finemote::emulator {
namespace {

/// Copies a structure out of the file, checking that it lies inside.
template <class T>
T at(const std::vector<std::uint8_t>& file, std::uint64_t offset) {
  if (offset + sizeof(T) > file.size()) throw std::runtime_error("the ELF file is cut off");
  T value;
  std::memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

std::string text_at(const std::vector<std::uint8_t>& file, std::uint64_t offset) {
  std::string text;
  while (offset < file.size() && file[offset] != 0) text += static_cast<char>(file[offset++]);
  return text;
}

void check(const Elf32_Ehdr& header) {
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) throw std::runtime_error("not an ELF file");
  if (header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_ident[EI_DATA] != ELFDATA2LSB || header.e_machine != EM_ARM) {
    throw std::runtime_error("not a 32-bit little-endian Arm ELF file");
  }
}

/// All of a section that holds `T`, which begins with an address: that is 0 for what was not linked.
template <class T>
std::vector<T> places_of(const std::vector<std::uint8_t>& file, const Elf32_Ehdr& header, const char* name) {
  const auto section_at = [&](unsigned s) {
    return at<Elf32_Shdr>(file, header.e_shoff + std::uint64_t{s} * header.e_shentsize);
  };
  std::vector<T> places;
  if (header.e_shstrndx >= header.e_shnum) return places;
  const Elf32_Shdr names = section_at(header.e_shstrndx);
  for (unsigned s = 0; s < header.e_shnum; ++s) {
    const Elf32_Shdr section = section_at(s);
    if (text_at(file, std::uint64_t{names.sh_offset} + section.sh_name) != name) continue;
    for (std::uint64_t offset = 0; offset + sizeof(T) <= section.sh_size; offset += sizeof(T)) {
      const T place = at<T>(file, section.sh_offset + offset);
      if (place.address != 0) places.push_back(place);
    }
  }
  return places;
}

void read_symbols(const std::vector<std::uint8_t>& file, const Elf32_Ehdr& header, Image& image) {
  for (unsigned s = 0; s < header.e_shnum; ++s) {
    const auto section = at<Elf32_Shdr>(file, header.e_shoff + std::uint64_t{s} * header.e_shentsize);
    if (section.sh_type != SHT_SYMTAB) continue;
    const auto names = at<Elf32_Shdr>(file, header.e_shoff + std::uint64_t{section.sh_link} * header.e_shentsize);
    for (std::uint64_t offset = 0; offset + sizeof(Elf32_Sym) <= section.sh_size; offset += sizeof(Elf32_Sym)) {
      const auto symbol = at<Elf32_Sym>(file, section.sh_offset + offset);
      const unsigned type = ELF32_ST_TYPE(symbol.st_info);
      if (type != STT_FUNC && type != STT_OBJECT && type != STT_NOTYPE) continue;
      if (symbol.st_shndx == SHN_UNDEF || symbol.st_name == 0) continue;
      const std::uint32_t address = type == STT_FUNC ? symbol.st_value & ~1U : symbol.st_value;
      image.symbols.emplace(text_at(file, std::uint64_t{names.sh_offset} + symbol.st_name),
                            Symbol{address, symbol.st_size});
    }
  }
}

/// What is loaded of a segment. A linker without a limit for pages lays the headers of the file before the flash.
Segment in_memory(const Elf32_Phdr& program, const std::vector<std::uint8_t>& file) {
  std::uint32_t headers = 0;
  if (program.p_paddr < Memories::kFlashBase && Memories::kFlashBase - program.p_paddr < program.p_filesz)
    headers = Memories::kFlashBase - program.p_paddr;
  const auto begin = file.begin() + static_cast<std::ptrdiff_t>(program.p_offset);
  return {program.p_paddr + headers, {begin + headers, begin + static_cast<std::ptrdiff_t>(program.p_filesz)}};
}

bool ends_in(const std::string& path, const std::string& ending) {
  return path.size() >= ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::optional<Symbol> Image::symbol(const std::string& name) const {
  const auto found = symbols.find(name);
  return found == symbols.end() ? std::nullopt : std::optional<Symbol>(found->second);
}

Image parse_image(const std::vector<std::uint8_t>& file) {
  const auto header = at<Elf32_Ehdr>(file, 0);
  check(header);
  Image image;
  for (unsigned p = 0; p < header.e_phnum; ++p) {
    const auto program = at<Elf32_Phdr>(file, header.e_phoff + std::uint64_t{p} * header.e_phentsize);
    if (program.p_type != PT_LOAD || program.p_filesz == 0) continue;
    if (std::uint64_t{program.p_offset} + program.p_filesz > file.size())
      throw std::runtime_error("the ELF file is cut off");
    image.segments.push_back(in_memory(program, file));
  }
  if (image.segments.empty()) throw std::runtime_error("the ELF file has nothing to load");
  read_symbols(file, header, image);
  image.marks = places_of<Mark>(file, header, ".debug_finemote");
  image.stamps = places_of<StampPlace>(file, header, ".debug_finemote_stamps");
  return image;
}

Image load_image(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read '" + path + "'");
  const std::vector<std::uint8_t> file{std::istreambuf_iterator<char>(in), {}};
  Image image;
  if (ends_in(path, ".hex")) {
    image.segments = parse_intel_hex({file.begin(), file.end()});
  } else if (ends_in(path, ".bin")) {
    image.segments = {{Memories::kFlashBase, file}};
  } else {
    return parse_image(file);
  }
  return image;
}

}  // namespace finemote::emulator
