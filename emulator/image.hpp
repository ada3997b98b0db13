// Reads a firmware ELF: what lies where, and what the symbols are.
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

struct Image {
  std::vector<Segment> segments;
  std::multimap<std::string, Symbol> symbols;

  /// The first symbol of this exact (mangled) name.
  [[nodiscard]] std::optional<Symbol> symbol(const std::string& name) const;
};

/// A 32-bit little-endian Arm ELF executable.
/// @throws std::runtime_error naming what is wrong with the file
Image load_image(const std::string& path);
Image parse_image(const std::vector<std::uint8_t>& file);

}  // namespace finemote::emulator
