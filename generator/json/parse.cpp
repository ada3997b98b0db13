#include "generator/json/parse.hpp"

#include <fmt/format.h>

#include <set>

namespace finemote::gen::json {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

int hex_digit(char c) {
  if (is_digit(c)) return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

void append_utf8(std::string& out, std::uint32_t c) {
  const auto byte = [&out](std::uint32_t b) { out += static_cast<char>(b); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | (c >> 6)), byte(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    byte(0xE0 | (c >> 12)), byte(0x80 | ((c >> 6) & 0x3F)), byte(0x80 | (c & 0x3F));
  } else {
    byte(0xF0 | (c >> 18)), byte(0x80 | ((c >> 12) & 0x3F)), byte(0x80 | ((c >> 6) & 0x3F)), byte(0x80 | (c & 0x3F));
  }
}

class Parser {
 public:
  Parser(const SourceFile& file, Diagnostics& diagnostics) : file_(file), text_(file.text), diagnostics_(diagnostics) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") pos_ = line_start_ = 3;
  }

  std::optional<Value> document() {
    skip_blanks();
    Value root;
    if (!value(root, 0)) return std::nullopt;
    skip_blanks();
    if (pos_ != text_.size()) return fail("unexpected text after the end of the document"), std::nullopt;
    return root;
  }

 private:
  [[nodiscard]] char peek() const { return pos_ < text_.size() ? text_[pos_] : '\0'; }
  [[nodiscard]] Position here() const {
    return {&file_, line_, static_cast<std::uint32_t>(pos_ - line_start_ + 1), nullptr};
  }

  bool fail(std::string message) {
    diagnostics_.error(code::json_malformed, here(), std::move(message));
    return false;
  }

  bool fail_expected(std::string_view what) {
    if (pos_ >= text_.size()) return fail(fmt::format("unexpected end of file, expected {}", what));
    const auto c = static_cast<unsigned char>(peek());
    if (c < 0x20 || c >= 0x7F) return fail(fmt::format("found byte 0x{:02x} where {} is expected", c, what));
    return fail(fmt::format("found '{}' where {} is expected", peek(), what));
  }

  void skip_blanks() {
    for (; pos_ < text_.size(); ++pos_) {
      const char c = text_[pos_];
      if (c == '\n') {
        ++line_;
        line_start_ = pos_ + 1;
      } else if (c != ' ' && c != '\t' && c != '\r') {
        return;
      }
    }
  }

  bool value(Value& out, int depth) {
    out.at = here();
    const std::size_t begin = pos_;
    const bool good = value_body(out, depth);
    const bool nested = out.is(Value::Kind::array) || out.is(Value::Kind::object);
    out.length = nested ? 1 : pos_ - begin;
    return good;
  }

  bool value_body(Value& out, int depth) {
    switch (peek()) {
      case '{':
        return deeper(depth) && object(out, depth + 1);
      case '[':
        return deeper(depth) && array(out, depth + 1);
      case '"':
        out.kind = Value::Kind::string;
        return string(out.text);
      case 't':
        out.kind = Value::Kind::boolean, out.truth = true;
        return word("true");
      case 'f':
        out.kind = Value::Kind::boolean;
        return word("false");
      case 'n':
        return word("null");
      default:
        break;
    }
    if (peek() == '-' || is_digit(peek())) return number(out);
    return fail_expected("a value");
  }

  bool deeper(int depth) {
    return depth < kMaxDepth || fail(fmt::format("arrays and objects are nested deeper than {}", kMaxDepth));
  }

  bool word(std::string_view expected) {
    if (text_.substr(pos_, expected.size()) != expected) return fail_expected("a value");
    pos_ += expected.size();
    return true;
  }

  void digits() {
    while (is_digit(peek())) ++pos_;
  }

  bool number(Value& out) {
    out.kind = Value::Kind::number;
    const std::size_t begin = pos_;
    if (peek() == '-') ++pos_;
    if (!is_digit(peek())) return fail_expected("a digit");
    if (peek() == '0') {
      ++pos_;
      if (is_digit(peek())) return fail("a number has no leading zero");
    }
    digits();
    if (peek() == '.') {
      ++pos_;
      if (!is_digit(peek())) return fail_expected("a digit");
      digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      ++pos_;
      if (peek() == '+' || peek() == '-') ++pos_;
      if (!is_digit(peek())) return fail_expected("a digit");
      digits();
    }
    out.text = text_.substr(begin, pos_ - begin);
    return true;
  }

  bool unit16(std::uint32_t& out) {
    out = 0;
    for (int i = 0; i < 4; ++i, ++pos_) {
      const int digit = hex_digit(peek());
      if (digit < 0) return fail_expected("a hexadecimal digit");
      out = out * 16 + static_cast<std::uint32_t>(digit);
    }
    return true;
  }

  bool unicode_escape(std::string& out) {
    std::uint32_t c = 0;
    if (!unit16(c)) return false;
    if (c >= 0xD800 && c < 0xDC00) {
      std::uint32_t low = 0;
      if (text_.substr(pos_, 2) != "\\u") return fail("half of a surrogate pair");
      pos_ += 2;
      if (!unit16(low)) return false;
      if (low < 0xDC00 || low > 0xDFFF) return fail("half of a surrogate pair");
      c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
    } else if (c >= 0xDC00 && c <= 0xDFFF) {
      return fail("half of a surrogate pair");
    }
    append_utf8(out, c);
    return true;
  }

  bool escape(std::string& out) {
    static constexpr std::string_view kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
    ++pos_;
    const char c = peek();
    if (c == 'u') return ++pos_, unicode_escape(out);
    const auto which = kFrom.find(c);
    if (c == '\0' || which == std::string_view::npos) return fail_expected("an escape");
    out += kTo[which];
    ++pos_;
    return true;
  }

  bool string(std::string& out) {
    for (++pos_;;) {
      if (pos_ >= text_.size()) return fail_expected("the end of the string");
      const char c = text_[pos_];
      if (c == '"') return ++pos_, true;
      if (static_cast<unsigned char>(c) < 0x20) return fail("a control character inside a string");
      if (c == '\\') {
        if (!escape(out)) return false;
      } else {
        out += c;
        ++pos_;
      }
    }
  }

  bool array(Value& out, int depth) {
    out.kind = Value::Kind::array;
    ++pos_;
    skip_blanks();
    if (peek() == ']') return ++pos_, true;
    for (;;) {
      if (!value(out.items.emplace_back(), depth)) return false;
      skip_blanks();
      if (peek() == ']') return ++pos_, true;
      if (peek() != ',') return fail_expected("',' or ']'");
      ++pos_;
      skip_blanks();
    }
  }

  bool object(Value& out, int depth) {
    out.kind = Value::Kind::object;
    std::set<std::string> keys;
    ++pos_;
    skip_blanks();
    if (peek() == '}') return ++pos_, true;
    for (;;) {
      if (!member(out, keys, depth)) return false;
      skip_blanks();
      if (peek() == '}') return ++pos_, true;
      if (peek() != ',') return fail_expected("',' or '}'");
      ++pos_;
      skip_blanks();
    }
  }

  bool member(Value& out, std::set<std::string>& keys, int depth) {
    Member m;
    m.at = here();
    if (peek() != '"') return fail_expected("a member name");
    const std::size_t begin = pos_;
    if (!string(m.key)) return false;
    const std::size_t length = pos_ - begin;
    skip_blanks();
    if (peek() != ':') return fail_expected("':'");
    ++pos_;
    skip_blanks();
    if (!value(m.value, depth)) return false;
    if (keys.insert(m.key).second) {
      out.members.push_back(std::move(m));
    } else {
      diagnostics_.error(code::json_repeated_key, m.at, fmt::format("member '{}' is repeated", m.key))
          .underline(length);
    }
    return true;
  }

  const SourceFile& file_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t pos_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace

std::string_view describe(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::null:
      return "null";
    case Value::Kind::boolean:
      return "true or false";
    case Value::Kind::number:
      return "a number";
    case Value::Kind::string:
      return "a string";
    case Value::Kind::array:
      return "an array";
    case Value::Kind::object:
      return "an object";
  }
  return "a value";
}

std::optional<Value> parse(const SourceFile& file, Diagnostics& diagnostics) {
  return Parser(file, diagnostics).document();
}

}  // namespace finemote::gen::json
