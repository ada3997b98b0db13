#include "generator/run/work_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>

#include "generator/file/system_reason.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {

namespace fs = std::filesystem;

WorkFolder::WorkFolder(const std::string& kept, Diagnostics& diagnostics) : path_(kept), keep_(!kept.empty()) {
  std::error_code failed;
  if (xml::find_invalid_utf8(kept) != std::string::npos) {
    diagnostics.error(code::output_not_writable, {},
                      fmt::format("cannot write '{}': its name is not UTF-8", path_.generic_string()));
    return;
  }
  if (keep_)
    fs::create_directories(path_, failed);
  else
    make_temporary(diagnostics);
  if (!failed) return;
  diagnostics.error(code::output_not_writable, {},
                    fmt::format("cannot write '{}': {}", path_.generic_string(), system_reason(failed.value())));
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!keep_ && !path_.empty()) fs::remove_all(path_, ignored);
}

void WorkFolder::make_temporary(Diagnostics& diagnostics) {
  std::error_code failed;
  const fs::path folder = fs::temp_directory_path(failed);
  std::string pattern = (folder / "finemote-run-XXXXXX").string();
  if (!failed && mkdtemp(pattern.data()) == nullptr) failed.assign(errno, std::generic_category());
  if (!failed) {
    path_ = pattern;
    return;
  }
  diagnostics
      .error(code::output_not_writable, {},
             fmt::format("cannot make a temporary folder: {}", system_reason(failed.value())))
      .hint("set TMPDIR to a folder that can be written, or give one with --keep");
}

}  // namespace finemote::gen
