#include "tests/structure/tokens.hpp"

#include <algorithm>
#include <cctype>

namespace finemote::test {
namespace {

bool begins_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool continues_word(char c) { return begins_word(c) || is_digit(c); }

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    while (at_ < text_.size()) step();
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] bool sees(std::string_view word) const { return text_.substr(at_, word.size()) == word; }

  void step() {
    const char c = peek();
    if (c == '\n') {
      advance(1);
      line_is_blank_ = true;
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0 || sees("\\\n")) {
      advance(1);
    } else if (sees("//")) {
      skip_line();
    } else if (sees("/*")) {
      skip_past("*/", 2);
    } else if (c == '#' && line_is_blank_) {
      skip_directive();
    } else {
      line_is_blank_ = false;
      read_token(c);
    }
  }

  void read_token(char c) {
    if (begins_word(c)) {
      read_word();
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      read_number();
    } else if (c == '"' || c == '\'') {
      read_quoted(c);
    } else {
      read(sees("::") || sees("->") ? 2 : 1);
    }
  }

  void read_word() {
    std::size_t size = 1;
    while (continues_word(peek(size))) ++size;
    const std::string_view word = text_.substr(at_, size);
    const char next = peek(size);
    const bool is_prefix = word == "u8" || word == "u" || word == "U" || word == "L";
    if (next == '"' && word.back() == 'R' && word.size() <= 3) {
      advance(size);
      read_raw_string();
    } else if (is_prefix && (next == '"' || next == '\'')) {
      advance(size);
      read_quoted(next);
    } else {
      read(size);
    }
  }

  /// Also `1'000`, `0x1F`, `1e-5` and `0x1p+3`.
  void read_number() {
    std::size_t size = 1;
    while (true) {
      const char before = text_[at_ + size - 1], c = peek(size);
      const bool is_exponent =
          (c == '+' || c == '-') && std::string_view("eEpP").find(before) != std::string_view::npos;
      const bool is_separator = c == '\'' && continues_word(peek(size + 1));
      if (!continues_word(c) && c != '.' && !is_exponent && !is_separator) break;
      ++size;
    }
    read(size);
  }

  void read_quoted(char quote) {
    tokens_.push_back({std::string(2, quote), line_, {}});
    advance(1);
    const std::size_t begin = at_;
    while (at_ < text_.size() && peek() != quote) advance(peek() == '\\' ? 2 : 1);
    tokens_.back().literal = text_.substr(begin, at_ - begin);
    advance(1);
  }

  void read_raw_string() {
    tokens_.push_back({"\"\"", line_, {}});
    const std::size_t open = text_.find('(', at_), begin = at_;
    if (open == std::string_view::npos) return advance(text_.size());
    skip_past(")" + std::string(text_.substr(at_ + 1, open - at_ - 1)) + "\"", open - at_);
    tokens_.back().literal = text_.substr(begin, at_ - begin);
  }

  /// To the end of the line, or of a later one where backslashes continue it.
  void skip_line() {
    while (at_ < text_.size() && peek() != '\n') advance(sees("\\\n") ? 2 : 1);
  }

  /// A comment that begins in a directive may end on a later line; no quotation does.
  void skip_directive() {
    while (at_ < text_.size() && peek() != '\n') {
      if (sees("//")) return skip_line();
      if (sees("/*")) {
        skip_past("*/", 2);
      } else if (peek() == '"' && text_.find_first_of("\"\n", at_ + 1) == text_.find('"', at_ + 1)) {
        skip_past("\"", 1);
      } else {
        advance(sees("\\\n") ? 2 : 1);
      }
    }
  }

  void skip_past(std::string_view end, std::size_t from) {
    const std::size_t found = text_.find(end, std::min(at_ + from, text_.size()));
    advance(found == std::string_view::npos ? text_.size() : found + end.size() - at_);
  }

  void read(std::size_t size) {
    tokens_.push_back({std::string(text_.substr(at_, size)), line_, {}});
    advance(size);
  }

  void advance(std::size_t size) {
    const std::string_view passed = text_.substr(at_, size);
    line_ += static_cast<int>(std::count(passed.begin(), passed.end(), '\n'));
    at_ += passed.size();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool line_is_blank_ = true;  ///< so far: here a `#` begins a directive
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) { return Lexer(text).run(); }

}  // namespace finemote::test
