// Compares an output folder with what a fresh run would write, and says of each file what is wrong with it.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {

struct Finding {
  /// `stale_timing`: not of the folder; the robot's timing file is of something else.
  enum class State { missing, hand_edited, line_endings, stale, orphan, stale_timing };
  State state = State::stale;
  std::string file;             ///< below the folder; of `stale_timing` its path
  std::string reason;           ///< a line, or the start of one
  bool follows_change = false;  ///< CheckResult::change goes on with it
};

struct CheckResult {
  std::vector<Finding> findings;  ///< in manifest order, then orphans by name; empty: fresh
  std::string change;             ///< why other files would be generated now
  bool tool_changed = false;      ///< the folder was written by another version of the tool, with the same bytes
  std::string manifest_change;  ///< why generate would write the manifest anew, and no other file; empty: it would not
  std::string previous_tool;

  /// The whole reason of a finding, one line.
  [[nodiscard]] std::string reason_of(const Finding& finding) const;
};

/// Reports what open_folder and FolderLock report; the folder is only read.
/// @param beyond  why files would be others although inputs, options and tool are the same
CheckResult check_output(const std::string& folder, const Output& output, const std::string& beyond,
                         Diagnostics& diagnostics);

/// `hand-edited`, `line-endings`, ...
const char* state_name(Finding::State state);

/// The findings of the folder as errors FM5007 to FM5011, each at its file below `folder`; `sources` keeps their names.
Diagnostics as_diagnostics(const std::string& folder, const CheckResult& result, Sources& sources);

/// Unified diff from the files on disk to those a fresh run would write, for the findings.
std::string unified_diff(const std::string& folder, const Output& output, const CheckResult& result);

}  // namespace finemote::gen
