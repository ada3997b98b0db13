#include "generator/diagnostic/printable.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

/// U+0080 to U+009F, U+202A to U+202E and U+2066 to U+2069: control sequences of terminals, and overrides of the
/// direction of writing (Unicode Standard Annex 9).
bool is_harmful(std::string_view letter) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  if (letter.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;
  if (letter.size() != 3 || byte(0) != 0xE2) return false;
  return (byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) ||
         (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9);
}

/// Bytes of the letter that begins with `byte`; 0 where none does.
std::size_t length_of_letter(unsigned char byte) {
  if (byte < 0x80) return 1;
  if (byte >= 0xC2 && byte < 0xE0) return 2;
  if (byte >= 0xE0 && byte < 0xF0) return 3;
  return byte >= 0xF0 && byte < 0xF5 ? 4 : 0;
}

bool is_whole(std::string_view letter) {
  return std::all_of(letter.begin() + 1, letter.end(),
                     [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80; });
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = length_of_letter(byte);
    const std::string_view letter = text.substr(i, std::max<std::size_t>(length, 1));
    const bool is_control = (byte < 0x20 && byte != '\t') || byte == 0x7F;
    if (length == 0 || is_control || letter.size() < length || !is_whole(letter)) {
      shown += '?';
      ++i;
      continue;
    }
    shown += is_harmful(letter) ? std::string(length, '?') : std::string(letter);
    i += length;
  }
  return shown;
}

std::string printable_lines(std::string_view text) {
  std::string shown;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    shown += (begin > 0 ? "\n  | " : "") + printable(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return shown;
}

}  // namespace finemote::gen
