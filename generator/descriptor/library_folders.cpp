#include "generator/descriptor/library_folders.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/descriptor/json_file.hpp"

namespace finemote::gen {
namespace fs = std::filesystem;
namespace {

/// How messages and outputs name a folder: relative to the input, with `/` at its end.
std::string display_folder(const fs::path& folder, const std::string& input_dir) {
  std::error_code problem;
  const fs::path base = fs::weakly_canonical(input_dir.empty() ? fs::path(".") : fs::path(input_dir), problem);
  const fs::path relative = fs::weakly_canonical(folder, problem).lexically_relative(base);
  return relative.empty() ? folder.filename().generic_string() + "/" : relative.generic_string() + "/";
}

/// A folder for device types holds descriptors of expanders as well: their "schema" says so.
bool describes_expander(const LibraryFile& file, const files::Access& access) {
  constexpr std::size_t kMost = std::size_t{1} << 20;
  const Json json = Json::parse(access.read(file.path, kMost).value_or(""), nullptr, /*allow_exceptions*/ false);
  const auto version = json.is_object() ? json.find("schema") : json.end();
  return version != json.end() && version->is_string() &&
         version->get_ref<const std::string&>().starts_with("finemote.expander/");
}

}  // namespace

std::vector<LibraryFile> list_folder(const fs::path& folder, const std::string& display, bool builtin,
                                     const files::Access& access, files::Denial& denial) {
  std::vector<LibraryFile> files;
  for (const std::string& name : access.list(folder.string(), denial)) {
    const fs::path file = folder / name;
    if (file.extension() == ".json")
      files.push_back({file.stem().string(), file.string(), display + name, builtin, false});
  }
  std::sort(files.begin(), files.end(), [](const LibraryFile& a, const LibraryFile& b) { return a.name < b.name; });
  return files;
}

void UserFolders::add(const fs::path& folder, For purpose) {
  files::Denial denial;
  auto found = list_folder(folder, display_folder(folder, input_dir_), false, sources_.access(), denial);
  if (denial.is_outside) {
    diagnostics_.error(code::outside_sandbox, {},
                       fmt::format("cannot read folder '{}': {}", folder.generic_string(), denial.reason));
  }
  for (LibraryFile& file : found) {
    if (purpose == For::boards)
      add_file(file, "board", library_.board_files);
    else if (describes_expander(file, sources_.access()))
      add_file(file, "expander", library_.expander_files);
    else
      add_file(file, "device type", library_.device_files);
  }
}

void UserFolders::add_given(const std::vector<std::string>& folders, For purpose) {
  for (const std::string& folder : folders) {
    if (sources_.access().holds_folder(folder)) {
      add(folder, purpose);
    } else {
      diagnostics_.error(
          code::unreadable_file, {},
          fmt::format("{} path '{}' is not a folder", purpose == For::boards ? "board" : "device type", folder));
    }
  }
}

void UserFolders::add_file(LibraryFile& file, const char* what, std::vector<LibraryFile>& files) {
  const auto same =
      std::find_if(files.begin(), files.end(), [&](const LibraryFile& other) { return other.name == file.name; });
  if (same == files.end()) {
    files.push_back(std::move(file));
    return;
  }
  std::error_code problem;
  if (fs::equivalent(same->path, file.path, problem)) return;
  const SourceFile* source = sources_.add(SourceFile{file.display, file.path, {}});
  diagnostics_.error(code::type_twice, {source, 0, 0, nullptr}, fmt::format("{} '{}' already exists", what, file.name))
      .note(same->builtin ? "FineMote ships one of this name" : fmt::format("also in {}", same->display))
      .hint("give this one another name, in the file and of the file");
}

}  // namespace finemote::gen
