#include "generator/image/source_lines.hpp"

#include "generator/image/debug_file.hpp"

namespace finemote::gen {

class SourceLines::File : public DebugFile {
 public:
  using DebugFile::DebugFile;
};

SourceLines::SourceLines(const std::string& path) : file_(std::make_unique<File>(path)) {}
SourceLines::~SourceLines() = default;

std::optional<SourceLine> SourceLines::at(std::uint32_t address) const {
  Dwarf_Die unit;
  if (file_->dwarf() == nullptr || dwarf_addrdie(file_->dwarf(), address, &unit) == nullptr) return std::nullopt;
  Dwarf_Line* line = dwarf_getsrc_die(&unit, address);
  const char* file = line == nullptr ? nullptr : dwarf_linesrc(line, nullptr, nullptr);
  int number = 0;
  if (file == nullptr || dwarf_lineno(line, &number) != 0) return std::nullopt;
  return SourceLine{file, number};
}

}  // namespace finemote::gen
