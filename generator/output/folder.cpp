#include "generator/output/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <sstream>

#include "generator/diagnostic/code_output.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/output/sha256.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

enum class Kind { folder, file };

void report_unreadable(const fs::path& path, int error, Diagnostics& diagnostics) {
  diagnostics.error(code::output_not_readable, {},
                    fmt::format("cannot read '{}': {}", path.generic_string(), system_reason(error)));
}

/// Reports what stands there and cannot be an output; nothing is there yet is fine.
void check_kind(const fs::path& path, Kind wanted, Diagnostics& diagnostics) {
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(path, failed);
  const std::string name = path.generic_string();
  if (status.type() == fs::file_type::none) {
    report_unreadable(path, failed.value(), diagnostics);
  } else if (fs::is_symlink(status)) {
    diagnostics.error(code::output_not_writable, {}, fmt::format("output '{}' is a symbolic link", name))
        .hint("remove the link, or give the real folder with -o");
  } else if (fs::exists(status) && wanted == Kind::folder && !fs::is_directory(status)) {
    diagnostics.error(code::output_not_writable, {}, fmt::format("output '{}' is not a folder", name))
        .hint("give another folder with -o");
  } else if (fs::exists(status) && wanted == Kind::file && !fs::is_regular_file(status)) {
    diagnostics.error(code::output_not_writable, {}, fmt::format("output '{}' is not a file", name))
        .hint("give another folder with -o");
  }
}

void check_readable(const fs::path& path, int how, Diagnostics& diagnostics) {
  if (::faccessat(AT_FDCWD, path.c_str(), how, AT_EACCESS) == 0 || errno == ENOENT) return;
  report_unreadable(path, errno, diagnostics);
}

/// All folders between the root and the files, the outer ones first.
std::set<fs::path> inner_folders(const fs::path& root, const Output& output, const Manifest& previous) {
  std::set<fs::path> folders;
  const auto add = [&](const std::string& name) {
    for (fs::path path = fs::path(name).parent_path(); !path.empty(); path = path.parent_path())
      folders.insert(root / path);
  };
  for (const OutputFile& file : output.files) add(file.name);
  for (const HashedFile& file : previous.outputs) {
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status((root / file.name).parent_path(), ignored);
    if (fs::is_directory(status) || fs::is_symlink(status)) add(file.name);  // else the file is gone
  }
  return folders;
}

void read_memory(Folder& folder, Diagnostics& diagnostics) {
  const fs::path path = folder.root / kManifestName;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return;
  folder.memory = Folder::Memory::broken;
  const std::string name = path.generic_string();
  const auto text = read_bytes(path.string());
  if (!text) {
    diagnostics
        .warning(code::broken_manifest, {}, fmt::format("cannot read manifest '{}': {}", name, system_reason(errno)))
        .hint("generate writes it anew; it replaces only files that hold what it would write");
    return;
  }
  if (auto manifest = parse_manifest(*text)) {
    folder.previous = std::move(*manifest);
    folder.memory = Folder::Memory::complete;
    return;
  }
  diagnostics.warning(code::broken_manifest, {}, fmt::format("'{}' is not a manifest of this version", name))
      .hint("generate writes it anew; it replaces only files that hold what it would write");
}

/// A root device that was renamed by letter case alone has the same files where the file system does not tell the cases
/// apart.
void spell_as_now(Folder& folder, const Output& output) {
  for (HashedFile& listed : folder.previous.outputs) {
    for (const OutputFile& file : output.files) {
      if (!is_one_file(folder.root, listed.name, file.name)) continue;
      listed.name = file.name;
      break;
    }
  }
}

}  // namespace

Output make_output(std::vector<OutputFile> files, std::vector<HashedFile> inputs, const std::string& robot,
                   std::vector<std::string> options) {
  Output output;
  output.files = std::move(files);
  output.manifest.tool = std::string("finemote ") + kVersion;
  output.manifest.robot = robot;
  output.manifest.options = std::move(options);
  output.manifest.inputs = std::move(inputs);
  for (const OutputFile& file : output.files) output.manifest.outputs.push_back({file.name, sha256(file.text)});
  return output;
}

std::vector<PlannedFile> planned_files(const std::string& folder, const Output& output, const std::string& option) {
  const fs::path root = folder_path(folder);
  std::vector<PlannedFile> planned;
  for (const OutputFile& file : output.files) planned.push_back({(root / file.name).generic_string(), option});
  planned.push_back({(root / kManifestName).generic_string(), option});
  return planned;
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

std::string without_carriage_returns(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

fs::path folder_path(const std::string& folder) {
  // A trailing separator would make the system look behind a link.
  fs::path root = fs::path(folder).lexically_normal();
  return root.has_filename() ? root : root.parent_path();
}

bool is_one_file(const fs::path& root, const std::string& a, const std::string& b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const auto is_same = [&](char one, char other) { return small(one) == small(other); };
  std::error_code missing;
  return a != b && std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same) &&
         fs::equivalent(root / a, root / b, missing);
}

bool check_root(const fs::path& root, Diagnostics& diagnostics) {
  check_kind(root, Kind::folder, diagnostics);
  if (!diagnostics.has_errors()) check_readable(root, R_OK | X_OK, diagnostics);
  return !diagnostics.has_errors();
}

std::optional<Folder> open_folder(const std::string& folder, const Output& output, const OtherRobot& other,
                                  Diagnostics& diagnostics) {
  Folder found;
  found.root = folder_path(folder);
  if (!check_root(found.root, diagnostics)) return std::nullopt;

  check_kind(found.root / kManifestName, Kind::file, diagnostics);
  if (!diagnostics.has_errors()) read_memory(found, diagnostics);
  spell_as_now(found, output);
  for (const fs::path& path : inner_folders(found.root, output, found.previous)) {
    check_kind(path, Kind::folder, diagnostics);
    if (!diagnostics.has_errors()) check_readable(path, R_OK | X_OK, diagnostics);
  }
  if (diagnostics.has_errors()) return std::nullopt;  // what lies below would repeat it
  for (const OutputFile& file : output.files) {
    check_kind(found.root / file.name, Kind::file, diagnostics);
    check_readable(found.root / file.name, R_OK, diagnostics);
  }
  const std::string& owner = found.previous.robot;
  if (found.memory == Folder::Memory::complete && owner != output.manifest.robot && !other.is_replaced) {
    diagnostics
        .error(code::folder_of_another_robot, {},
               fmt::format("'{}' holds the output of robot '{}', not of '{}'", found.root.generic_string(), owner,
                           output.manifest.robot))
        .hint(other.way_out);
  }
  if (diagnostics.has_errors()) return std::nullopt;
  return found;
}

}  // namespace finemote::gen
