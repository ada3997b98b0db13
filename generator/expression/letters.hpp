// Letter case and classes of characters, for the scripts of Europe; independent of the locale.
#pragma once

namespace finemote::gen::expression {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

char32_t to_upper(char32_t c);
char32_t to_lower(char32_t c);
bool is_upper(char32_t c);
bool is_lower(char32_t c);
bool is_letter(char32_t c);  ///< beyond the scripts known here, every character that is no punctuation counts
bool is_decimal(char32_t c);
bool is_space(char32_t c);

}  // namespace finemote::gen::expression
