// What one rule of lint finds, and what would mend it.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/lint/change.hpp"
#include "generator/model/robot.hpp"

namespace finemote::gen {

/// What mends one finding mechanically.
struct Fix {
  Code code;
  std::string message;  ///< of the finding
  std::string subject;  ///< name of the device that moves, or of the bus that goes
  Change change;        ///< without edits where the text does not allow it
};

/// Where a rule puts what it finds: every finding gets the code of the rule, and is an error where that is denied.
class Findings {
 public:
  Findings(Code code, bool is_denied, Diagnostics& diagnostics, std::vector<Fix>& fixes)
      : code_(code), is_denied_(is_denied), diagnostics_(diagnostics), fixes_(fixes) {}

  /// Whether they are errors.
  [[nodiscard]] bool is_denied() const { return is_denied_; }

  /// @return  to note and hint at, until the next finding
  Diagnostic& add(Position at, std::string message) {
    return is_denied_ ? diagnostics_.error(code_, at, std::move(message))
                      : diagnostics_.warning(code_, at, std::move(message));
  }
  /// At the tag of the device.
  Diagnostic& add(const Device& device, std::string message) {
    return add(device.at, std::move(message)).underline(std::string_view("<device").size());
  }
  /// A finding of the timing analysis.
  void add(Diagnostic finding) {
    if (is_denied_) finding.severity = Severity::error;
    diagnostics_.add(finding);
  }
  void fix(const Diagnostic& finding, std::string subject, Change change) {
    fixes_.push_back({finding.code, finding.message, std::move(subject), std::move(change)});
  }

 private:
  Code code_;
  bool is_denied_;
  Diagnostics& diagnostics_;
  std::vector<Fix>& fixes_;
};

}  // namespace finemote::gen
