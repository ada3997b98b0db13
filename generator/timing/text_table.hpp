// Rows of cells to lines of text with aligned columns.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace finemote::gen::timing {

/// Rows with columns as wide as their widest cell: the first one to the left, all others to the right.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> head) { row(std::move(head)); }
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace finemote::gen::timing
