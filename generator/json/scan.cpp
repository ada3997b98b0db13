#include "generator/json/scan.hpp"

#include <fmt/format.h>

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

}  // namespace

Scanner::Scanner(const SourceFile& file, Diagnostics& diagnostics)
    : file_(file), text_(file.text), diagnostics_(diagnostics) {
  if (text_.substr(0, 3) == "\xEF\xBB\xBF") pos_ = line_start_ = 3;
}

bool Scanner::fail(std::string message) {
  diagnostics_.error(code::json_malformed, here(), std::move(message));
  return false;
}

bool Scanner::fail_expected(std::string_view what) {
  if (at_end()) return fail(fmt::format("unexpected end of file, expected {}", what));
  const auto c = static_cast<unsigned char>(peek());
  if (c < 0x20 || c >= 0x7F) return fail(fmt::format("found byte 0x{:02x} where {} is expected", c, what));
  return fail(fmt::format("found '{}' where {} is expected", peek(), what));
}

void Scanner::skip_blanks() {
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

bool Scanner::take(char c) {
  if (at_end() || peek() != c) return false;
  ++pos_;
  return true;
}

bool Scanner::word(std::string_view expected) {
  if (text_.substr(pos_, expected.size()) != expected) return fail_expected("a value");
  pos_ += expected.size();
  return true;
}

void Scanner::digits() {
  while (is_digit(peek())) ++pos_;
}

bool Scanner::number(std::string& out) {
  const std::size_t begin = pos_;
  take('-');
  if (!is_digit(peek())) return fail_expected("a digit");
  if (take('0') && is_digit(peek())) return fail("a number has no leading zero");
  digits();
  if (!fraction() || !exponent()) return false;
  out = text_.substr(begin, pos_ - begin);
  return true;
}

bool Scanner::fraction() {
  if (!take('.')) return true;
  if (!is_digit(peek())) return fail_expected("a digit");
  digits();
  return true;
}

bool Scanner::exponent() {
  if (!take('e') && !take('E')) return true;
  if (!take('+')) take('-');
  if (!is_digit(peek())) return fail_expected("a digit");
  digits();
  return true;
}

bool Scanner::string(std::string& out) {
  for (++pos_;;) {
    if (at_end()) return fail_expected("the end of the string");
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

bool Scanner::escape(std::string& out) {
  static constexpr std::string_view kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
  ++pos_;
  if (take('u')) return unicode_escape(out);
  const auto which = kFrom.find(peek());
  if (peek() == '\0' || which == std::string_view::npos) return fail_expected("an escape");
  out += kTo[which];
  ++pos_;
  return true;
}

bool Scanner::unicode_escape(std::string& out) {
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

bool Scanner::unit16(std::uint32_t& out) {
  out = 0;
  for (int i = 0; i < 4; ++i, ++pos_) {
    const int digit = hex_digit(peek());
    if (digit < 0) return fail_expected("a hexadecimal digit");
    out = out * 16 + static_cast<std::uint32_t>(digit);
  }
  return true;
}

}  // namespace finemote::gen::json
