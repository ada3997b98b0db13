// The folder a run generates and builds in.
#pragma once

#include <filesystem>
#include <string>

#include "generator/diagnostic/diagnostics.hpp"

namespace finemote::gen {

/// A temporary folder that is removed at the end, or one that is kept.
class WorkFolder {
 public:
  /// Makes the folder. Reports FM5002 when that fails.
  /// @param kept  the folder to keep; empty: a temporary one
  WorkFolder(const std::string& kept, Diagnostics& diagnostics);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  void make_temporary(Diagnostics& diagnostics);

  std::filesystem::path path_;
  bool keep_;
};

}  // namespace finemote::gen
