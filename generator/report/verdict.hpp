// Documents to the first line of a report, and the few figures below it that say most.
#pragma once

#include <string>

#include "generator/report/documents.hpp"

namespace finemote::gen::report {

struct Verdict {
  bool is_good = false;
  std::string text;  ///< `FinsROV keeps every deadline and every requirement`
};

Verdict verdict_of(const Documents& documents, const std::string& robot);

/// Worst age of a command, load of the processor and the busiest bus; of a run also sizes and what it kept.
std::string headline_figures(const Documents& documents);

}  // namespace finemote::gen::report
