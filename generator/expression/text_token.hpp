// A text as Python spells it, with quotes and escapes: 'a', r"\d", """b""".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace finemote::gen::expression {

/// Length of the letters before the quote (r, b, u, f) when a text begins `rest`, else npos.
std::size_t text_prefix(std::string_view rest);

struct TextToken {
  std::string text;           ///< what it means
  std::size_t length = 0;     ///< of its spelling, with prefix and quotes
  std::size_t last_line = 0;  ///< in which it ends
};

/// Reads the string literal at the start of `rest`. Fails with the words of Python's tokenizer.
/// @param prefix  as text_prefix() gives it
/// @param line    in which it begins
TextToken read_text_token(std::string_view rest, std::size_t prefix, std::size_t line);

}  // namespace finemote::gen::expression
