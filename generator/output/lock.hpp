// Keeps two processes from writing into one folder at a time.
#pragma once

#include <filesystem>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// A lock on a folder itself, held as long as the object lives: no file is left behind, and a process that is killed
/// leaves no lock. Where the file system has no locks (some network drives), there is none.
class FolderLock {
 public:
  enum class Use {
    look,   ///< with others that look; a folder that is not there is not made
    write,  ///< alone; a missing folder is made, and removed again by remove_created()
  };

  /// Waits up to 5 s for others. Reports FM5005 when they do not end, FM5002 when the folder cannot be made.
  FolderLock(const std::filesystem::path& folder, Use use, Diagnostics& diagnostics);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Removes the folders that were made for it, unless something is in them.
  void remove_created();

 private:
  bool open(const std::filesystem::path& folder, Diagnostics& diagnostics);
  bool wait(int operation);
  [[nodiscard]] bool is_still(const std::filesystem::path& folder) const;
  void close();

  int descriptor_ = -1;
  Use use_;
  std::vector<std::filesystem::path> created_;  ///< the outermost first
};

/// Makes a folder and those around it; returns those that were not there, the outermost first. Throws
/// filesystem_error; then none of them is left.
std::vector<std::filesystem::path> create_folders(const std::filesystem::path& folder);

/// Removes folders made by create_folders, as far as they are empty.
void remove_folders(const std::vector<std::filesystem::path>& created);

}  // namespace finemote::gen
