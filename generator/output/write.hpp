// Puts the output on disk: only what changed, all or nothing, the manifest last.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {

struct WriteOptions {
  bool dry_run = false;              ///< touch nothing; the result says what would be, or FM5002 for a folder that is
                                     ///< read-only
  bool force = false;                ///< move users' files out of the way instead of reporting them
  bool warnings_are_errors = false;  ///< write nothing when there is a warning
  /// What the user can do about files of theirs, as a hint.
  std::string way_out = "--force keeps every such file as NAME.orig and then writes; -o names another folder";
  /// The same of a folder that belongs to another robot.
  std::string other_robot = OtherRobot().way_out;
};

/// What a run did to the folder, each sorted as in the manifest.
struct WriteResult {
  std::vector<std::string> written, unchanged, removed;
  std::vector<std::pair<std::string, std::string>> moved;  ///< users' files: from, to
};

/// Writes every file whose bytes differ to a temporary file beside it, puts them all in place when all are complete,
/// removes files that only the previous manifest lists, and puts the manifest in place last. Holds a FolderLock.
///
/// Reports what FolderLock and open_folder report; FM5004 for each file that is the user's (Ownership) and would be
/// overwritten or removed, unless `force`: then it is moved to NAME.orig, or NAME.orig.2 and so on; FM5002 with the
/// system's reason when the folder cannot be written. After an error nothing has changed. `sources` keeps the names of
/// files that are reported.
WriteResult write_output(const std::string& folder, const Output& output, const WriteOptions& options, Sources& sources,
                         Diagnostics& diagnostics);

}  // namespace finemote::gen
