#include "generator/expression/letters.hpp"

#include "generator/expression/utf8.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen::expression {
namespace {

bool between(char32_t c, char32_t low, char32_t high) { return low <= c && c <= high; }

/// Latin Extended-A pairs a capital with the small letter after it; the capital is even, except in these stretches.
bool is_odd_pair(char32_t c) { return between(c, 0x139, 0x148) || between(c, 0x179, 0x17E); }
bool is_paired(char32_t c) {
  return between(c, 0x100, 0x17E) && c != 0x130 && c != 0x131 && c != 0x138 && c != 0x149 && c != 0x178;
}
bool is_paired_capital(char32_t c) { return is_paired(c) && (c % 2 == 0) != is_odd_pair(c); }
bool is_paired_small(char32_t c) { return is_paired(c) && (c % 2 == 0) == is_odd_pair(c); }

bool is_latin1_capital(char32_t c) { return between(c, 0xC0, 0xDE) && c != 0xD7; }
bool is_latin1_small(char32_t c) { return between(c, 0xE0, 0xFE) && c != 0xF7; }
bool is_greek_capital(char32_t c) { return between(c, 0x391, 0x3A9) && c != 0x3A2; }
bool is_greek_small(char32_t c) { return between(c, 0x3B1, 0x3C9) && c != 0x3C2; }

}  // namespace

char32_t to_upper(char32_t c) {
  if (between(c, 'a', 'z') || is_latin1_small(c) || is_greek_small(c) || between(c, 0x430, 0x44F)) return c - 32;
  if (between(c, 0x450, 0x45F)) return c - 80;
  if (c == 0xFF) return 0x178;
  if (c == 0xB5) return 0x39C;
  if (c == 0x3C2) return 0x3A3;
  return is_paired_small(c) ? c - 1 : c;
}

char32_t to_lower(char32_t c) {
  if (between(c, 'A', 'Z') || is_latin1_capital(c) || is_greek_capital(c) || between(c, 0x410, 0x42F)) return c + 32;
  if (between(c, 0x400, 0x40F)) return c + 80;
  if (c == 0x178) return 0xFF;
  return is_paired_capital(c) ? c + 1 : c;
}

bool is_upper(char32_t c) { return to_lower(c) != c; }
bool is_lower(char32_t c) { return to_upper(c) != c || c == 0xDF; }

bool is_letter(char32_t c) {
  if (c < 0x80) return is_upper(c) || is_lower(c);
  if (c < 0xC0) return c == 0xAA || c == 0xB5 || c == 0xBA;
  return c != 0xD7 && c != 0xF7 && !between(c, 0x2000, 0x2BFF) && !between(c, 0x3000, 0x303F) && c < 0x1F000;
}

bool is_decimal(char32_t c) { return between(c, '0', '9'); }

bool is_space(char32_t c) { return xml::is_blank_text(encode(c)); }

}  // namespace finemote::gen::expression
