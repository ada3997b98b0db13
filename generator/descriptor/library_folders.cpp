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

/// As much of a file as is looked at to tell what it describes.
std::string begin_of(const LibraryFile& file, const files::Access& access) {
  constexpr std::size_t kMost = std::size_t{1} << 20;
  return access.read(file.path, kMost).value_or("");
}

/// What a file says it is; empty where it does not.
std::string version_of(const LibraryFile& file, const files::Access& access) {
  return peek_text(begin_of(file, access), "schema").value_or("");
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
  if (!denial.reason.empty()) {
    diagnostics_.error(denial.is_outside ? code::outside_sandbox : code::unreadable_file, {},
                       fmt::format("cannot read folder '{}': {}", folder.generic_string(), denial.reason));
  }
  for (const LibraryFile& file : found) {
    if (purpose == For::boards)
      add_board(file);
    else
      add_descriptor(file);
  }
}

void UserFolders::add_board(const LibraryFile& file) {
  if (kChipFormat.is_kind_of(version_of(file, sources_.access())))
    add_file(file, kChipFormat, library_.chip_files);
  else
    add_file(file, kBoardFormat, library_.board_files);
}

void UserFolders::add_descriptor(const LibraryFile& file) {
  const std::string version = version_of(file, sources_.access());
  const bool is_device = kDeviceFormat.is_kind_of(version), is_expander = kExpanderFormat.is_kind_of(version);
  if (!is_device) add_file(file, kExpanderFormat, library_.expander_files);
  if (!is_expander) add_file(file, kDeviceFormat, library_.device_files);
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

void UserFolders::add_file(const LibraryFile& file, const FileFormat& format, std::vector<LibraryFile>& files) {
  const auto same =
      std::find_if(files.begin(), files.end(), [&](const LibraryFile& other) { return other.name == file.name; });
  if (same == files.end()) {
    files.push_back(file);
    return;
  }
  std::error_code problem;
  if (fs::equivalent(same->path, file.path, problem)) return;
  const SourceFile* source = sources_.add({file.display, file.path, begin_of(file, sources_.access())});
  const Extent extent = find_value(*source, {format.name_key});
  diagnostics_.error(code::type_twice, extent.at, fmt::format("{} '{}' already exists", format.what, file.name))
      .underline(extent.length)
      .note(same->builtin ? "FineMote ships one of this name" : fmt::format("also in {}", same->display))
      .hint("give this one another name, in the file and of the file");
}

}  // namespace finemote::gen
