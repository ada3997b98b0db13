// Reads a linked firmware image (ELF32, Arm, little endian) into sections, symbols and bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

struct ImageSection {
  std::string name;
  std::uint32_t address = 0;  ///< where it lives when the program runs
  std::uint32_t size = 0;
  bool allocated = false;  ///< part of the program, not debug information
  bool has_bytes = false;  ///< its bytes are in the file: code, constants, initial values
  bool writable = false;
  bool executable = false;
  std::string_view bytes;  ///< empty when !has_bytes; points into Image::file

  /// The bytes from `at` on are its.
  [[nodiscard]] bool holds(std::uint32_t at, std::uint32_t count) const;
  /// The start of the program sets all of it to zero. Source: sections.ld of the chip, as of is_filled().
  [[nodiscard]] bool is_zeroed() const;
  /// It has its first values when the program begins: the start fills it, or it lies in the flash. What lies in a
  /// section of its own is none of that.
  [[nodiscard]] bool is_filled() const;
};

struct ImageSymbol {
  std::string name;           ///< as in the file, mangled
  std::uint32_t address = 0;  ///< of functions without the Thumb bit
  std::uint32_t size = 0;
  enum class Kind { function, object, mapping, other } kind = Kind::other;
  std::uint16_t section = 0;  ///< index into Image::sections; 0: undefined or absolute
};

/// A firmware image. Move-only: views point into `file`.
struct Image {
  Image() = default;
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  Image(Image&&) = default;
  Image& operator=(Image&&) = default;

  std::vector<char> file;
  std::vector<ImageSection> sections;  ///< in file order, index 0 is the empty one
  std::vector<ImageSymbol> symbols;    ///< by address, then name

  /// The first symbol of this name, or null.
  [[nodiscard]] const ImageSymbol* find(std::string_view name) const;
  /// A function begins there.
  [[nodiscard]] bool is_function(std::uint32_t address) const;
  /// The little-endian word at an address the file has bytes for.
  [[nodiscard]] std::optional<std::uint32_t> word(std::uint32_t address) const;
  /// The bytes from `address` on, at most `size`; empty when the file has none there.
  [[nodiscard]] std::string_view bytes(std::uint32_t address, std::uint32_t size) const;
};

/// Reports FM6101 when the file cannot be read or is not such an image; whatever is in the file, nothing else happens.
std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics);

/// `finemote::now()` for `_ZN8finemote3nowEv`; the name itself where it is not mangled.
std::string readable_name(const std::string& symbol);

}  // namespace finemote::gen
