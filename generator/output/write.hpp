// Puts the output on disk: only what changed, all or nothing, the manifest last.
#pragma once

#include <string>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {

/// What a run did to the folder, each sorted as in the manifest.
struct WriteResult {
  std::vector<std::string> written, unchanged, removed;
};

/// Writes every file whose bytes differ to a temporary file beside it, renames them all when all are complete,
/// removes files that only the previous manifest lists, and renames the manifest last. With `dry_run` nothing is
/// touched and the result says what would be. Reports FM5002 when the folder cannot be written; then nothing changed.
WriteResult write_output(const std::string& folder, const Output& output, bool dry_run, Diagnostics& diagnostics);

}  // namespace finemote::gen
