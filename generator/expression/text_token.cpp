#include "generator/expression/text_token.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/expression/integer.hpp"
#include "generator/expression/token.hpp"
#include "generator/expression/utf8.hpp"

namespace finemote::gen::expression {
namespace {

class TextReader {
 public:
  TextReader(std::string_view source, std::size_t line) : source_(source), first_line_(line), line_(line) {}

  TextToken run(std::size_t prefix) {
    const bool raw = is_raw(prefix);
    const char quote = peek(prefix);
    const bool triple = peek(prefix + 1) == quote && peek(prefix + 2) == quote;
    std::size_t length = prefix + (triple ? 3 : 1);
    for (;;) {
      const char c = peek(length);
      if (length >= source_.size() || (c == '\n' && !triple)) fail_unterminated(triple);
      if (c == quote && (!triple || (peek(length + 1) == quote && peek(length + 2) == quote))) break;
      if (c == '\n') ++line_;
      if (c == '\\') {
        length += read_escape(length, raw);
      } else {
        text_ += c;
        ++length;
      }
    }
    return {std::move(text_), length + (triple ? 3 : 1), line_};
  }

 private:
  [[nodiscard]] char peek(std::size_t at) const { return at < source_.size() ? source_[at] : '\0'; }

  [[nodiscard]] bool is_raw(std::size_t prefix) const {
    bool raw = false;
    for (std::size_t i = 0; i < prefix; ++i) {
      const char c = peek(i);
      raw = raw || c == 'r' || c == 'R';
      if (c == 'b' || c == 'B') fail_syntax("bytes are not supported", line_);
      if (c == 'f' || c == 'F') fail_syntax("f-strings are not supported", line_);
    }
    return raw;
  }

  [[noreturn]] void fail_unterminated(bool triple) const {
    const char* kind = triple ? "triple-quoted string" : "string";
    fail_syntax(fmt::format("unterminated {} literal (detected at line {})", kind, line_), first_line_);
  }

  /// Appends what `\x..` at `offset` means; returns its length.
  std::size_t read_escape(std::size_t offset, bool raw) {
    const char c = peek(offset + 1);
    if (raw) {
      text_ += '\\';
      if (offset + 1 < source_.size()) text_ += c;
      return 2;
    }
    static constexpr std::string_view spelled = "\\'\"abfnrtv";
    static constexpr std::string_view meant = "\\'\"\a\b\f\n\r\t\v";
    if (const auto simple = spelled.find(c); simple != std::string_view::npos && c != '\0') {
      text_ += meant[simple];
      return 2;
    }
    if (c == '\n') return 2;
    if (c == 'x') return read_coded(offset, 2, 16);
    if (c == 'u') return read_coded(offset, 4, 16);
    if (c == 'U') return read_coded(offset, 8, 16);
    if (c >= '0' && c <= '7') return read_octal(offset);
    text_ += '\\';
    return 1;
  }

  std::size_t read_coded(std::size_t offset, std::size_t digits, unsigned base) {
    const std::string_view spelling = source_.substr(std::min(offset + 2, source_.size()), digits);
    const auto value = spelling.size() == digits ? parse_digits(spelling, base) : std::nullopt;
    const bool is_character =
        value && value->small() < 0x110000 && (value->small() < 0xD800 || value->small() > 0xDFFF);
    if (!is_character) fail_syntax("(unicode error) 'unicodeescape' codec can't decode bytes", line_);
    text_ += encode(static_cast<char32_t>(value->small()));
    return digits + 2;
  }

  std::size_t read_octal(std::size_t offset) {
    std::size_t digits = 1;
    while (digits < 3 && peek(offset + 1 + digits) >= '0' && peek(offset + 1 + digits) <= '7') ++digits;
    const auto value = parse_digits(source_.substr(offset + 1, digits), 8);
    text_ += encode(static_cast<char32_t>(value->small()));
    return digits + 1;
  }

  std::string_view source_;
  std::size_t first_line_;
  std::size_t line_;
  std::string text_;
};

}  // namespace

std::size_t text_prefix(std::string_view rest) {
  constexpr std::size_t longest = 2;
  const std::size_t length = std::min(rest.substr(0, longest + 1).find_first_not_of("rRuUfFbB"), longest);
  const bool has_quote = length < rest.size() && (rest[length] == '\'' || rest[length] == '"');
  return has_quote ? length : std::string_view::npos;
}

TextToken read_text_token(std::string_view rest, std::size_t prefix, std::size_t line) {
  return TextReader(rest, line).run(prefix);
}

}  // namespace finemote::gen::expression
