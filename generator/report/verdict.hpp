// Documents to the first line of a report, and the few figures below it that say most.
#pragma once

#include <string>

#include "generator/report/documents.hpp"

namespace finemote::gen::report {

struct Verdict {
  /// `open`: nothing is wrong, and not everything is proven.
  enum class Look { good, open, bad };
  Look look = Look::bad;
  std::string text;  ///< `FinsROV meets every deadline and every requirement`
};

/// Bad where `analyze` or `run` would exit with 1 for what the documents hold, open where some command has no bound of
/// its age; the text names the first reason.
Verdict verdict_of(const Documents& documents, const std::string& robot);

/// What the execution times are that the verdict rests on: `Execution times: static for 12 devices, assumed for 1.`
std::string rests_on(const Documents& documents);

/// Worst age of a command, load of the processor and the busiest bus; of a run also sizes and what it kept.
std::string headline_figures(const Documents& documents);

}  // namespace finemote::gen::report
