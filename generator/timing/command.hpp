// `finemote analyze`, from a model on.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "generator/timing/analyse.hpp"

namespace finemote::gen::timing {

struct AnalyzeOptions {
  std::optional<Profile> profile;
  std::vector<std::string> chains;  ///< `a->b`
  bool slack = false;
  bool suggest_order = false;
  std::optional<Ns> assume_wcet_ns;  ///< per stage of every device whose execution times are assumed
  bool json = false;
  Remodel remodel;  ///< of the description the model comes from; none: the model itself is changed
};

/// `paper`, `tight`, `target`; none for other words.
std::optional<Profile> profile_of(std::string_view name);

/// Analyses and writes the table or the JSON document to `out`; findings go to `diagnostics` (and into the document).
/// Returns the exit status: 0, 1 (not schedulable in the asked profile, or a requirement fails), 2 (no answer; nothing
/// is written).
int run_analyze(Model model, const std::vector<Requirement>& requirements, const AnalyzeOptions& options,
                Diagnostics& diagnostics, std::ostream& out);

}  // namespace finemote::gen::timing
