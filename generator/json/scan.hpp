// The tokens of a JSON text, one after the other, each with its place: blanks, words, numbers and strings.
#pragma once

#include <string>
#include <string_view>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen::json {

/// Walks over one text. What it takes is taken whole or reported as FM4001 where the text goes wrong: every function
/// that returns false has reported, and the walk is over.
class Scanner {
 public:
  /// Starts after a UTF-8 byte order mark. Both arguments outlive the scanner.
  Scanner(const SourceFile& file, Diagnostics& diagnostics);

  /// The next byte; 0 at the end.
  [[nodiscard]] char peek() const { return pos_ < text_.size() ? text_[pos_] : '\0'; }
  [[nodiscard]] bool at_end() const { return pos_ == text_.size(); }
  [[nodiscard]] std::size_t offset() const { return pos_; }
  [[nodiscard]] Position here() const {
    return {&file_, line_, static_cast<std::uint32_t>(pos_ - line_start_ + 1), nullptr};
  }

  void skip_blanks();
  /// Takes one byte if it is the next one.
  bool take(char c);
  /// Takes `true`, `false` or `null`.
  bool word(std::string_view expected);
  /// Takes a number; `out` gets it as written.
  bool number(std::string& out);
  /// Takes a string with its quotes; `out` gets it decoded to UTF-8.
  bool string(std::string& out);

  /// Reports at the next byte. @return false
  bool fail(std::string message);
  /// Reports what stands there instead of `what`. @return false
  bool fail_expected(std::string_view what);

 private:
  void digits();
  bool fraction();
  bool exponent();
  bool escape(std::string& out);
  bool unicode_escape(std::string& out);
  bool unit16(std::uint32_t& out);

  const SourceFile& file_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t pos_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace finemote::gen::json
