// Files as the debug information of an image calls them, to names that are the same wherever the image was made.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace finemote::gen {

class SourceNames {
 public:
  /// @param data_dir      holds runtime: its files are `finemote/runtime/...`
  /// @param robot_folder  of the robot: files below are named from there
  SourceNames(const std::string& data_dir, const std::string& robot_folder);

  /// Generated files are `generated/...`; of files that are nowhere known the last part of the name is left.
  [[nodiscard]] std::string of(const std::string& file) const;
  /// A file of the compiler's libraries: neither of the robot nor of FineMote, and not there or among the headers of
  /// C++.
  [[nodiscard]] bool is_of_library(const std::string& file) const;

 private:
  /// What it is called below one of the folders; empty: it is in none.
  [[nodiscard]] std::string known_name(const std::string& file) const;

  std::vector<std::pair<std::string, std::string>> roots_;  ///< folder, what names begin with
};

}  // namespace finemote::gen
