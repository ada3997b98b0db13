// Waits until something changes that an answer was made from.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/diagnostic/source.hpp"

namespace finemote::gen {

/// What the answer of a command depends on: the files that were read, where further ones may come, and the folder that
/// is checked.
std::vector<std::string> watched_paths(const Options& options, const Sources& sources);

/// Files and folders as they were at one time. Nothing is told by the system: they are looked at every tenth of a
/// second.
class Watched {
 public:
  /// @param paths  files, missing ones too, and folders, of which every file counts
  explicit Watched(std::vector<std::string> paths);

  /// Returns when some file came, went or was written, and all of them have been at rest for a moment.
  void wait() const;

 private:
  /// Size, time of the last change in nanoseconds of the file system, and number of a file.
  struct Mark {
    std::uint64_t size = 0, changed = 0, number = 0;
    friend bool operator==(const Mark&, const Mark&) = default;
  };
  using Marks = std::map<std::string, Mark>;
  [[nodiscard]] Marks look() const;

  std::vector<std::string> paths_;
  Marks marks_;
};

}  // namespace finemote::gen
