#include "generator/output/folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "generator/output/sha256.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

void report_kind(const fs::path& path, const char* wanted, Diagnostics& diagnostics) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (fs::is_symlink(status)) {
    diagnostics
        .error(code::output_not_writable, {}, fmt::format("output '{}' is a symbolic link", path.generic_string()))
        .hint("remove the link, or give the real folder with -o");
  } else if (fs::exists(status) && std::string_view(wanted) == "folder" && !fs::is_directory(status)) {
    diagnostics.error(code::output_not_writable, {}, fmt::format("output '{}' is not a folder", path.generic_string()))
        .hint("give another folder with -o");
  } else if (fs::exists(status) && std::string_view(wanted) == "file" && !fs::is_regular_file(status)) {
    diagnostics.error(code::output_not_writable, {}, fmt::format("output '{}' is not a file", path.generic_string()));
  }
}

}  // namespace

Output make_output(std::vector<OutputFile> files, std::vector<HashedFile> inputs, const std::string& robot) {
  Output output;
  output.files = std::move(files);
  output.manifest.tool = std::string("finemote ") + kVersion;
  output.manifest.robot = robot;
  output.manifest.inputs = std::move(inputs);
  for (const OutputFile& file : output.files) output.manifest.outputs.push_back({file.name, sha256(file.text)});
  return output;
}

std::optional<std::string> read_bytes(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::optional<Manifest> open_folder(const std::string& folder, const Output& output, Diagnostics& diagnostics) {
  // A trailing separator would make the system look behind a link.
  fs::path root = fs::path(folder).lexically_normal();
  if (!root.has_filename()) root = root.parent_path();
  report_kind(root, "folder", diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::set<fs::path> folders;
  for (const OutputFile& file : output.files) {
    const fs::path path = root / file.name;
    if (path.parent_path() != root) folders.insert(path.parent_path());
    report_kind(path, "file", diagnostics);
  }
  for (const fs::path& path : folders) report_kind(path, "folder", diagnostics);
  report_kind(root / kManifestName, "file", diagnostics);

  const auto text = read_bytes((root / kManifestName).string());
  if (!text) return std::nullopt;
  const auto manifest = parse_manifest(*text);
  if (!manifest) {
    diagnostics
        .error(code::broken_manifest, {},
               fmt::format("'{}' in '{}' is no manifest of this version", kManifestName, root.generic_string()))
        .hint("delete the folder and generate again");
  } else if (manifest->robot != output.manifest.robot) {
    diagnostics
        .error(code::folder_of_another_robot, {},
               fmt::format("'{}' holds the output of robot '{}', not of '{}'", root.generic_string(), manifest->robot,
                           output.manifest.robot))
        .hint("give each robot a folder of its own with -o");
  }
  return manifest;
}

}  // namespace finemote::gen
