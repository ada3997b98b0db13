// Byte offsets of a text to positions: a cursor that only walks forward, so a whole file costs one pass.
#pragma once

#include <algorithm>
#include <cstddef>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen::xml {

class Locator {
 public:
  explicit Locator(const SourceFile& file) : file_(&file), line_end_(end_of_line(0)) {}

  /// Line and byte column (both from 1) of `offset`; offsets may go back to an earlier line, which costs a walk from
  /// the beginning.
  Position at(std::size_t offset) {
    offset = std::min(offset, file_->text.size());
    if (offset < line_start_) line_ = 1, line_start_ = 0, line_end_ = end_of_line(0);
    while (line_end_ < offset) {
      line_start_ = line_end_ + 1;
      line_end_ = end_of_line(line_start_);
      ++line_;
    }
    return {file_, line_, static_cast<std::uint32_t>(offset - line_start_ + 1)};
  }

 private:
  [[nodiscard]] std::size_t end_of_line(std::size_t start) const {
    return std::min(file_->text.find('\n', start), file_->text.size());
  }

  const SourceFile* file_;
  std::uint32_t line_ = 1;
  std::size_t line_start_ = 0;
  std::size_t line_end_;  ///< kept: a file may be one line
};

}  // namespace finemote::gen::xml
