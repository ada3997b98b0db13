// Reads a file of firmware: what lies where, and of an ELF file what the symbols are.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace finemote::emulator {

struct Segment {
  std::uint32_t address;  ///< load address: in flash also for initialised data
  std::vector<std::uint8_t> bytes;
};

struct Symbol {
  std::uint32_t address = 0;  ///< without the Thumb bit
  std::uint32_t size = 0;
};

/// A place in the code that the image tells tools of, without an instruction: section `.debug_finemote`, a word for the
/// address of each and one for what it stands for.
struct Mark {
  std::uint32_t address = 0;
  std::uint32_t number = 0;
};

/// Where a device keeps when its data were taken (`finemote::Stamp`), known by the stage of its update.
struct StampPlace {
  std::uint32_t address = 0;
  std::uint32_t stage = 0;
};

struct Image {
  std::vector<Segment> segments;
  std::vector<Mark> marks;
  std::vector<StampPlace> stamps;  ///< section `.debug_finemote_stamps`
  std::multimap<std::string, Symbol> symbols;

  /// The first symbol of this exact (mangled) name.
  [[nodiscard]] std::optional<Symbol> symbol(const std::string& name) const;
};

/// By the end of its name: `.hex` is Intel HEX, `.bin` the bytes of the flash from its start on, anything else a 32-bit
/// little-endian Arm ELF executable, which alone has marks and symbols.
/// @throws std::runtime_error naming what is wrong with the file
Image load_image(const std::string& path);
Image parse_image(const std::vector<std::uint8_t>& file);

}  // namespace finemote::emulator
