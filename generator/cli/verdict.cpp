#include "generator/cli/verdict.hpp"

namespace finemote::gen {

std::optional<Verdict> verdict_of(const Analysis& analysis, Diagnostics& diagnostics) {
  if (!analysis.timing) {
    for (const Diagnostic& finding : analysis.findings.in_file_order()) {
      if (finding.severity == Severity::error) diagnostics.error(finding.code, finding.at, finding.message);
    }
    return std::nullopt;
  }
  Verdict verdict;
  verdict.schedulable = analysis.timing->schedulable;
  verdict.requirements_hold = analysis.timing->requirements_hold();
  Diagnostics reasons;
  for (const Diagnostic& finding : analysis.findings.in_file_order()) {
    if (finding.code == code::timing_bus_overload)
      verdict.overloads.push_back(finding);
    else
      reasons.add(finding);
  }
  if (reasons.has_errors()) verdict.reasons = std::move(reasons);
  return verdict;
}

}  // namespace finemote::gen
