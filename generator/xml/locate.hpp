// Byte offsets of a text to positions: a cursor that only walks forward, so a whole file costs one pass.
#pragma once

#include <cstddef>
#include <string_view>

#include "generator/diagnostic/source.hpp"

namespace finemote::gen::xml {

class Locator {
 public:
  explicit Locator(const SourceFile& file) : file_(&file) {}

  /// Line and byte column (both from 1) of `offset`; offsets may go back, which costs a walk from the beginning.
  Position at(std::size_t offset) {
    const std::string_view text = file_->text;
    if (offset > text.size()) offset = text.size();
    if (offset < line_start_) line_ = 1, line_start_ = 0;
    for (;;) {
      const auto end = text.find('\n', line_start_);
      if (end == std::string_view::npos || end >= offset) break;
      line_start_ = end + 1;
      ++line_;
    }
    return {file_, line_, static_cast<std::uint32_t>(offset - line_start_ + 1)};
  }

 private:
  const SourceFile* file_;
  std::uint32_t line_ = 1;
  std::size_t line_start_ = 0;
};

}  // namespace finemote::gen::xml
