#include "generator/image/image.hpp"

#include <cxxabi.h>
#include <elf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include <fmt/format.h>

namespace finemote::gen {
namespace {

/// Bounds-checked access to the bytes of the file.
class Reader {
 public:
  explicit Reader(const std::vector<char>& bytes) : bytes_(bytes) {}

  template <class T>
  std::optional<T> at(std::uint64_t offset) const {
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof(T)) return std::nullopt;
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }
  std::string_view view(std::uint64_t offset, std::uint64_t size) const {
    if (offset > bytes_.size() || bytes_.size() - offset < size) return {};
    return {bytes_.data() + offset, static_cast<std::size_t>(size)};
  }

 private:
  const std::vector<char>& bytes_;
};

std::string text_at(std::string_view table, std::uint32_t offset) {
  if (offset >= table.size()) return {};
  const std::string_view rest = table.substr(offset);
  return std::string(rest.substr(0, rest.find('\0')));
}

bool is_arm_executable(const Elf32_Ehdr& header) {
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS32 &&
         header.e_ident[EI_DATA] == ELFDATA2LSB && header.e_machine == EM_ARM && header.e_type == ET_EXEC &&
         header.e_shentsize == sizeof(Elf32_Shdr);
}

ImageSection section_from(const Elf32_Shdr& header, const Reader& reader) {
  ImageSection section;
  section.address = header.sh_addr;
  section.size = header.sh_size;
  section.allocated = (header.sh_flags & SHF_ALLOC) != 0;
  section.has_bytes = header.sh_type != SHT_NOBITS && header.sh_type != SHT_NULL;
  section.writable = (header.sh_flags & SHF_WRITE) != 0;
  section.executable = (header.sh_flags & SHF_EXECINSTR) != 0;
  if (section.has_bytes) section.bytes = reader.view(header.sh_offset, header.sh_size);
  return section;
}

ImageSymbol::Kind kind_of(const Elf32_Sym& symbol, const std::string& name) {
  switch (ELF32_ST_TYPE(symbol.st_info)) {
    case STT_FUNC:
      return ImageSymbol::Kind::function;
    case STT_OBJECT:
      return ImageSymbol::Kind::object;
    default:
      return name.size() > 1 && name[0] == '$' ? ImageSymbol::Kind::mapping : ImageSymbol::Kind::other;
  }
}

void read_symbols(const Reader& reader, const Elf32_Shdr& header, std::string_view names, Image& image) {
  for (std::uint64_t i = 1; i < header.sh_size / sizeof(Elf32_Sym); ++i) {
    const auto entry = reader.at<Elf32_Sym>(header.sh_offset + i * sizeof(Elf32_Sym));
    if (!entry) return;
    ImageSymbol symbol;
    symbol.name = text_at(names, entry->st_name);
    symbol.kind = kind_of(*entry, symbol.name);
    const bool code = symbol.kind == ImageSymbol::Kind::function;
    symbol.address = code ? entry->st_value & ~1U : entry->st_value;
    symbol.size = entry->st_size;
    symbol.section = entry->st_shndx < image.sections.size() ? entry->st_shndx : std::uint16_t{0};
    const bool is_of_notes = symbol.kind == ImageSymbol::Kind::mapping && !image.sections[symbol.section].allocated;
    if (!symbol.name.empty() && !is_of_notes) image.symbols.push_back(std::move(symbol));
  }
}

bool read_sections(const Reader& reader, const Elf32_Ehdr& header, Image& image) {
  std::vector<Elf32_Shdr> headers;
  for (unsigned i = 0; i < header.e_shnum; ++i) {
    const auto entry = reader.at<Elf32_Shdr>(header.e_shoff + std::uint64_t{i} * sizeof(Elf32_Shdr));
    if (!entry) return false;
    headers.push_back(*entry);
    image.sections.push_back(section_from(*entry, reader));
  }
  if (header.e_shstrndx >= headers.size()) return false;
  const std::string_view names = image.sections[header.e_shstrndx].bytes;
  for (std::size_t i = 0; i < headers.size(); ++i) image.sections[i].name = text_at(names, headers[i].sh_name);
  for (const Elf32_Shdr& entry : headers) {
    if (entry.sh_type != SHT_SYMTAB || entry.sh_link >= headers.size()) continue;
    read_symbols(reader, entry, image.sections[entry.sh_link].bytes, image);
  }
  return !image.symbols.empty();
}

}  // namespace

bool ImageSection::holds(std::uint32_t at, std::uint32_t count) const {
  return at >= address && at - address + count <= size;
}

bool ImageSection::is_zeroed() const { return name == ".bss" || name == ".core_bss"; }

bool ImageSection::is_filled() const {
  return is_zeroed() || name == ".data" || name == ".dma_constants" || name == ".rodata";
}

const ImageSymbol* Image::find(std::string_view name) const {
  const auto found = std::find_if(symbols.begin(), symbols.end(), [&](const auto& s) { return s.name == name; });
  return found == symbols.end() ? nullptr : &*found;
}

bool Image::is_function(std::uint32_t address) const {
  const auto first = std::lower_bound(symbols.begin(), symbols.end(), address,
                                      [](const ImageSymbol& s, std::uint32_t a) { return s.address < a; });
  return std::any_of(first, symbols.end(), [&](const ImageSymbol& s) {
    return s.address == address && s.kind == ImageSymbol::Kind::function;
  });
}

std::string_view Image::bytes(std::uint32_t address, std::uint32_t size) const {
  for (const ImageSection& section : sections) {
    if (!section.allocated || section.bytes.empty() || address < section.address) continue;
    const std::uint32_t offset = address - section.address;
    if (offset < section.bytes.size()) return section.bytes.substr(offset, size);
  }
  return {};
}

std::optional<std::uint32_t> Image::word(std::uint32_t address) const {
  const std::string_view four = bytes(address, 4);
  if (four.size() < 4) return std::nullopt;
  std::uint32_t value;
  std::memcpy(&value, four.data(), sizeof value);
  return value;
}

std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics) {
  std::ifstream stream(path, std::ios::binary);
  Image image;
  image.file.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (!stream.is_open() || stream.bad()) {
    diagnostics.error(code::bad_image, {}, fmt::format("cannot read the image '{}'", path));
    return std::nullopt;
  }
  const Reader reader(image.file);
  const auto header = reader.at<Elf32_Ehdr>(0);
  if (!header || !is_arm_executable(*header) || !read_sections(reader, *header, image)) {
    diagnostics.error(code::bad_image, {}, fmt::format("'{}' is not a linked Arm image with symbols", path));
    return std::nullopt;
  }
  std::stable_sort(image.symbols.begin(), image.symbols.end(), [](const ImageSymbol& a, const ImageSymbol& b) {
    return a.address != b.address ? a.address < b.address : a.name < b.name;
  });
  return image;
}

std::string readable_name(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 && name ? std::string(name.get()) : symbol;
}

}  // namespace finemote::gen
