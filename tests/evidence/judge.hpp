// From a vector and what our code makes of it to a verdict.
#pragma once

#include <string>
#include <vector>

#include "tests/evidence/decoders.hpp"

namespace finemote::evidence {

enum class Verdict { agree, differs, explained, no_decoder, unknown_field };

struct Judgement {
  Verdict verdict = Verdict::agree;
  std::string explanation;  ///< names, with commas between them
  std::vector<std::string> explained_fields;
  std::vector<std::string> remarks;  ///< one per field that differs or is not known

  /// `agree`, `explained NAME`, ...
  [[nodiscard]] std::string text() const;
};

/// The decoder of a protocol; null where no device type speaks it.
Decoder decoder_of(const std::string& protocol);

Judgement judge(const Vector& vector);

}  // namespace finemote::evidence
