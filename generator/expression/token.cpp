#include "generator/expression/token.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "generator/expression/failure.hpp"
#include "generator/expression/letters.hpp"
#include "generator/expression/number.hpp"
#include "generator/expression/text_token.hpp"

namespace finemote::gen::expression {
namespace {

constexpr std::array<std::string_view, 35> kKeywords = {
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

/// Longest first, so that the first match is right.
constexpr std::array<std::string_view, 34> kSymbols = {
    "**", "//", "<<", ">>", "<=", ">=", "==", "!=", ":=", "->", "+", "-", "*", "/", "%", "@", "&",
    "|",  "^",  "~",  "<",  ">",  "(",  ")",  "[",  "]",  "{",  "}", ",", ":", ".", ";", "=", "\\"};

bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool is_name_part(char c) { return is_name_start(c) || is_digit(c); }

char closer_of(char opener) { return opener == '(' ? ')' : opener == '[' ? ']' : '}'; }

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view source) : source_(source) {}

  std::vector<Token> run() {
    tokens_.reserve(source_.size() / 3 + 2);
    for (skip_blanks(); at_ < source_.size(); skip_blanks()) read_token();
    if (!open_.empty()) fail_syntax(fmt::format("'{}' was never closed", open_.back().symbol), open_.back().line);
    tokens_.push_back({Token::Kind::end, {}, {}, line_});
    return std::move(tokens_);
  }

 private:
  struct Bracket {
    char symbol;
    std::size_t line;
  };

  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  void skip_blanks() {
    for (; at_ < source_.size(); ++at_) {
      const char c = source_[at_];
      if (c == '#') {
        while (at_ + 1 < source_.size() && source_[at_ + 1] != '\n') ++at_;
      } else if (c == '\n') {
        if (open_.empty() && !tokens_.empty()) fail_syntax("invalid syntax", line_);
        ++line_;
      } else if (c != ' ' && c != '\t' && c != '\r' && c != '\f') {
        return;
      }
    }
  }

  void read_token() {
    const char c = peek();
    if (const std::size_t prefix = text_prefix(source_.substr(at_)); prefix != std::string_view::npos)
      return read_text(prefix);
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return read_number();
    if (is_name_start(c)) return read_name();
    read_symbol();
  }

  void add(Token::Kind kind, std::size_t length, Value value = {}) {
    tokens_.push_back({kind, source_.substr(at_, length), std::move(value), line_});
    at_ += length;
  }

  void read_name() {
    std::size_t length = 1;
    while (is_name_part(peek(length))) ++length;
    add(Token::Kind::name, length);
  }

  void read_symbol() {
    const std::string_view rest = source_.substr(at_);
    const auto symbol = std::find_if(kSymbols.begin(), kSymbols.end(), [&](auto s) { return rest.starts_with(s); });
    if (symbol == kSymbols.end()) fail_syntax("invalid syntax", line_);
    track_bracket((*symbol)[0]);
    add(Token::Kind::symbol, symbol->size());
  }

  void track_bracket(char c) {
    if (c == '(' || c == '[' || c == '{') {
      open_.push_back({c, line_});
      if (open_.size() > 200) fail_syntax("too many nested parentheses", line_);
    }
    if (c != ')' && c != ']' && c != '}') return;
    if (open_.empty()) fail_syntax(fmt::format("unmatched '{}'", c), line_);
    if (closer_of(open_.back().symbol) != c) {
      fail_syntax(
          fmt::format("closing parenthesis '{}' does not match opening parenthesis '{}'", c, open_.back().symbol),
          line_);
    }
    open_.pop_back();
  }

  void read_number() {
    static constexpr std::string_view kind = "invalid decimal literal";
    const char second = static_cast<char>(std::tolower(static_cast<unsigned char>(peek(1))));
    if (peek() == '0' && (second == 'x' || second == 'o' || second == 'b')) return read_based(second);
    std::size_t length = 0;
    const auto digits = [&] {
      while (is_digit(peek(length)) || (peek(length) == '_' && is_digit(peek(length + 1)))) ++length;
    };
    digits();
    bool is_real = false;
    if (peek(length) == '.') is_real = true, ++length, digits();
    if (peek(length) == 'e' || peek(length) == 'E') {
      const std::size_t sign = peek(length + 1) == '+' || peek(length + 1) == '-' ? 1 : 0;
      if (is_digit(peek(length + 1 + sign))) is_real = true, length += 1 + sign, digits();
    }
    if (peek(length) == 'j' || peek(length) == 'J') fail_syntax("complex numbers are not supported", line_);
    check_number_end(length, kind);
    const std::string_view spelling = source_.substr(at_, length);
    if (is_real) return add(Token::Kind::number, length, *parse_real(spelling));
    const Integer value = *parse_integer(spelling);
    if (spelling.size() > 1 && spelling[0] == '0' && !value.is_zero()) {
      fail_syntax("leading zeros in decimal integer literals are not permitted; use an 0o prefix for octal integers",
                  line_);
    }
    add(Token::Kind::number, length, value);
  }

  void read_based(char mark) {
    const unsigned base = mark == 'x' ? 16 : mark == 'o' ? 8 : 2;
    const char* name = mark == 'x' ? "hexadecimal" : mark == 'o' ? "octal" : "binary";
    std::size_t length = 2;
    while (std::isalnum(static_cast<unsigned char>(peek(length))) != 0 || peek(length) == '_') ++length;
    const auto digits = without_underscores("0" + std::string(source_.substr(at_ + 2, length - 2)));
    const auto value = digits && length > 2 ? parse_digits(*digits, base) : std::nullopt;
    if (!value) fail_syntax(fmt::format("invalid {} literal", name), line_);
    add(Token::Kind::number, length, *value);
  }

  /// `1if x else 2` is legal Python, `1x` is not.
  void check_number_end(std::size_t length, std::string_view message) const {
    if (!is_name_part(peek(length))) return;
    std::size_t end = length;
    while (is_name_part(peek(end))) ++end;
    if (!is_keyword(source_.substr(at_ + length, end - length))) fail_syntax(message, line_);
  }

  void read_text(std::size_t prefix) {
    TextToken text = read_text_token(source_.substr(at_), prefix, line_);
    line_ = text.last_line;  // where a text that goes over lines ends
    add(Token::Kind::text, text.length, std::move(text.text));
  }

  std::string_view source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<Bracket> open_;
  std::vector<Token> tokens_;
};

}  // namespace

void fail_syntax(std::string_view message, std::size_t line) {
  fail_eval(fmt::format("{} (<expression>, line {})", message, line));
}

bool is_keyword(std::string_view word) {
  constexpr std::size_t shortest = 2;
  constexpr std::size_t longest = 8;
  if (word.size() < shortest || word.size() > longest) return false;
  return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

bool is_identifier(std::string_view word) {
  return !word.empty() && is_name_start(word[0]) && std::all_of(word.begin(), word.end(), is_name_part) &&
         !is_keyword(word);
}

std::vector<Token> tokenize_expression(std::string_view source) { return Tokenizer(source).run(); }

}  // namespace finemote::gen::expression
