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

 private:
  std::vector<std::pair<std::string, std::string>> roots_;  ///< folder, what names begin with
};

}  // namespace finemote::gen
