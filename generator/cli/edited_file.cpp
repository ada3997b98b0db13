#include "generator/cli/edited_file.hpp"

#include <fmt/format.h>

#include "generator/diagnostic/code_output.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {

std::optional<std::string> mark_before(const SourceFile& file, Sources& sources, Diagnostics& diagnostics) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const auto bytes = file.path.empty() ? std::nullopt : read_bytes(file.path);
  if (bytes == file.text) return "";
  if (bytes && *bytes == std::string(kByteOrderMark) + file.text) return std::string(kByteOrderMark);
  auto& finding = diagnostics.error(code::file_not_editable, {sources.add({file.name, file.path, {}})},
                                    fmt::format("cannot edit '{}': {}", file.name,
                                                file.path.empty() ? "it is no file"
                                                                  : "it is not in UTF-8, or changed while it was "
                                                                    "checked"));
  finding.hint(file.path.empty() ? "save it, and give the name of the file" : "save the file as UTF-8");
  return std::nullopt;
}

}  // namespace finemote::gen
