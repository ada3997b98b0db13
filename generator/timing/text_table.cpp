#include "generator/timing/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace finemote::gen::timing {

std::string TextTable::text() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line = fmt::format("  {:<{}}", row.front(), widths.front());
    for (std::size_t c = 1; c < row.size(); ++c) {
      const bool remark = c + 1 == row.size() && rows_.front()[c].empty();
      line += remark ? "  " + row[c] : fmt::format("  {:>{}}", row[c], widths[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace finemote::gen::timing
