#include "generator/run/compiled_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "generator/diagnostic/code_scenario.hpp"
#include "generator/diagnostic/printable.hpp"
#include "generator/file/inside.hpp"
#include "generator/output/folder.hpp"
#include "generator/run/process.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

std::string real_path(const fs::path& path) {
  std::error_code ignored;
  return fs::weakly_canonical(path, ignored).generic_string();
}

/// Whose files are none of the robot's.
std::vector<std::string> folders_of_others(const FirmwareRequest& request, const fs::path& build) {
  const fs::path data = request.data_dir;  // a build has links in it to the sources
  std::vector<std::string> folders{real_path(request.folder), real_path(data / "runtime"), real_path(data / "cmake")};
  std::istringstream of_compiler(read_bytes((build / kCompilerFolders).string()).value_or(std::string()));
  for (std::string folder; std::getline(of_compiler, folder, ';');) {
    if (!folder.empty()) folders.push_back(real_path(folder));
  }
  return folders;
}

bool is_below(const std::string& file, const std::vector<std::string>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const std::string& folder) { return file.rfind(folder + "/", 0) == 0; });
}

/// From the working folder on, where the file lies below it.
std::string shown(const std::string& file) {
  std::error_code failed;
  const auto place = inside(file, fs::current_path(failed));
  return printable(place ? place->generic_string() : file);
}

}  // namespace

std::optional<std::vector<std::string>> compiled_files(const FirmwareRequest& request, Diagnostics& diagnostics) {
  const fs::path build = fs::path(request.folder) / "build";
  const ProcessResult said = run_process({"ninja", "-C", build.string(), "-t", "deps"}, std::chrono::seconds(60));
  if (!said.started || said.timed_out || said.exit_status != 0) {
    diagnostics.error(code::firmware_build_failed, {}, "asking Ninja what was compiled failed");
    return std::nullopt;
  }
  const std::vector<std::string> others = folders_of_others(request, build);
  std::set<std::string> files;
  std::istringstream lines(said.output);
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view kIndent = "    ";
    if (line.rfind(kIndent, 0) != 0) continue;
    std::string file = real_path(build / line.substr(kIndent.size()));
    if (!is_below(file, others)) files.insert(std::move(file));
  }
  return std::vector<std::string>(files.begin(), files.end());
}

bool are_known(const std::vector<std::string>& compiled, const std::vector<std::string>& known,
               Diagnostics& diagnostics) {
  std::set<std::string> found;
  for (const std::string& path : known) found.insert(real_path(path));
  const auto is_hidden = [&](const std::string& file) { return found.count(file) == 0; };
  const auto first = std::find_if(compiled.begin(), compiled.end(), is_hidden);
  if (first == compiled.end()) return true;
  const auto more = std::count_if(first + 1, compiled.end(), is_hidden);
  diagnostics
      .error(code::hidden_include, {},
             fmt::format("the compiler reads '{}'{}, and finemote does not find that a source of the robot includes {}",
                         shown(*first), more == 0 ? "" : fmt::format(" and {} more", more), more == 0 ? "it" : "them"))
      .note("bounds would stay valid although this file changes")
      .hint("include it by its name: #include \"...\"");
  return false;
}

}  // namespace finemote::gen
