#include "generator/diagnostic/diagnostics.hpp"

#include <algorithm>

namespace finemote::gen {

std::vector<Diagnostic> Diagnostics::in_file_order() const {
  std::vector<Diagnostic> sorted(list_.begin(), list_.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return before(a.at, b.at); });
  return sorted;
}

}  // namespace finemote::gen
