// Collects what is wrong with an input; one run reports all mistakes, in file order.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/diagnostic/code.hpp"
#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

/// A note says what a user may want to know and asks for nothing: `-W error` leaves it one.
enum class Severity { error, warning, note };

/// Further information below a message, with a place of its own or none.
struct Note {
  std::string message;
  Position at;
};

/// One finding. Message, notes and hints are lower case, without full stop, names in single quotes.
struct Diagnostic {
  Severity severity = Severity::error;
  Code code;
  Position at;
  std::size_t length = 1;  ///< bytes the caret underlines
  std::string message;
  std::vector<Note> notes;
  std::vector<std::string> hints;  ///< text that can be pasted

  Diagnostic& underline(std::size_t bytes) { return length = bytes > 0 ? bytes : 1, *this; }
  Diagnostic& note(std::string text, Position where = {}) { return notes.push_back({std::move(text), where}), *this; }
  Diagnostic& hint(std::string text) { return hints.push_back(std::move(text)), *this; }
};

/// The findings of one run. A stage adds to it and carries on; the caller asks has_errors() between stages.
class Diagnostics {
 public:
  Diagnostic& error(Code code, Position at, std::string message) {
    ++errors_;
    return add(Severity::error, code, at, std::move(message));
  }
  Diagnostic& warning(Code code, Position at, std::string message) {
    ++warnings_;
    return add(Severity::warning, code, at, std::move(message));
  }
  Diagnostic& remark(Code code, Position at, std::string message) {
    return add(Severity::note, code, at, std::move(message));
  }
  /// A finding made elsewhere.
  void add(const Diagnostic& finding) {
    if (finding.severity == Severity::error) ++errors_;
    if (finding.severity == Severity::warning) ++warnings_;
    list_.push_back(finding);
  }
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] bool has_errors_or_warnings() const { return errors_ + warnings_ > 0; }
  [[nodiscard]] std::size_t size() const { return list_.size(); }

  /// All findings in file order (stable: findings at one place keep the order they were made in).
  [[nodiscard]] std::vector<Diagnostic> in_file_order() const;

 private:
  Diagnostic& add(Severity severity, Code code, Position at, std::string message) {
    return list_.emplace_back(Diagnostic{severity, code, at, 1, std::move(message), {}, {}});
  }
  std::deque<Diagnostic> list_;  // references handed out stay valid
  std::size_t errors_ = 0, warnings_ = 0;
};

}  // namespace finemote::gen
