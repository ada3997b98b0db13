#include "generator/run/code_line.hpp"

#include <string_view>

namespace finemote::gen {

std::optional<SourceLine> code_line(const SourceLines& lines, std::uint32_t address) {
  constexpr std::string_view kMarks = "finemote/loop_bound.hpp";
  constexpr std::uint32_t kFarEnough = 16;  // bytes
  for (std::uint32_t at = address; at < address + kFarEnough; at += 2) {
    auto line = lines.at(at);
    if (line && !line->file.ends_with(kMarks)) return line;
  }
  return lines.at(address);
}

}  // namespace finemote::gen
