// Where a source of a vector and our code differ on purpose: exactly how, and who else says what ours says.
#pragma once

#include <string>
#include <vector>

#include "tests/evidence/findings.hpp"

namespace finemote::evidence {

/// A field of a vector that does not come out as its source says.
struct Difference {
  const Vector* vector;
  const Findings* findings;
  std::string field;                    ///< "accepted" where our code refuses the whole frame
  std::vector<double> expected, found;  ///< in the same unit; empty for texts
};

struct Explanation {
  const char* name;
  const char* protocols;  ///< with spaces between them
  const char* differs;    ///< what the source says and what our code does
  const char* third;      ///< who else says it
  bool (*covers)(const Difference& difference);
};

const std::vector<Explanation>& explanations();

}  // namespace finemote::evidence
