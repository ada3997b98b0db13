#include "generator/scaffold/new_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "generator/diagnostic/code_output.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/file/system_reason.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Returns the error number of the system, or 0.
int write_one(const fs::path& path, const std::string& text) {
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  return error ? error.value() : create_file(path, text);
}

}  // namespace

bool are_new(const std::string& folder, const std::vector<std::string>& names, Diagnostics& diagnostics) {
  Diagnostic* last = nullptr;
  for (const std::string& name : names) {
    const std::string path = (fs::path(folder) / name).generic_string();
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(path, ignored))) continue;
    last = &diagnostics.error(code::file_exists, {}, fmt::format("'{}' is already there", path));
  }
  if (last == nullptr) return true;
  last->hint("nothing was written: these files are yours; name another folder, or move them away");
  return false;
}

bool write_new(const std::string& folder, const std::vector<OutputFile>& files, Diagnostics& diagnostics) {
  std::vector<fs::path> written;
  for (const OutputFile& file : files) {
    const fs::path path = fs::path(folder) / file.name;
    const int error = write_one(path, file.text);
    if (error == 0) {
      written.push_back(path);
      continue;
    }
    diagnostics.error(code::output_not_writable, {},
                      fmt::format("cannot write '{}': {}", path.generic_string(), system_reason(error)));
    std::error_code ignored;
    for (const fs::path& done : written) fs::remove(done, ignored);
    return false;
  }
  return true;
}

}  // namespace finemote::gen
