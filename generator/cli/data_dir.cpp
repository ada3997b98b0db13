#include "generator/cli/data_dir.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "generator/file/installed_file.hpp"
#include "generator/run/program_folder.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

bool holds_data(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "schemas" / "boards", error) && fs::is_directory(folder / "templates", error);
}

}  // namespace

std::string find_data_dir(const std::string& wanted, Diagnostics& diagnostics) {
  std::vector<fs::path> places;
  const char* environment = std::getenv("FINEMOTE_DATA");
  if (!wanted.empty()) {
    places = {wanted};
  } else if (environment != nullptr && *environment != '\0') {
    places = {environment};
  } else {
    const fs::path program = program_folder();
    places = {program / "share", program.parent_path() / "share" / "finemote"};
  }
  for (const fs::path& place : places) {
    if (holds_data(place)) return place.lexically_normal().string();
  }
  auto& finding =
      diagnostics.error(code::data_not_found, {}, "cannot find the folder with schemas, templates and runtime");
  for (const fs::path& place : places) finding.note(fmt::format("searched in '{}'", place.generic_string()));
  finding.hint("set --data-dir or the environment variable FINEMOTE_DATA");
  return {};
}

std::optional<std::string> read_data_file(const std::string& path, Diagnostics& diagnostics) {
  try {
    return read_installed(path);
  } catch (const DamagedInstallation& damage) {
    diagnostics.error(code::data_not_found, {}, damage.what()).hint(kInstallAgain);
    return std::nullopt;
  }
}

}  // namespace finemote::gen
