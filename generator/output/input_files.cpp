#include "generator/output/input_files.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "generator/file/inside.hpp"
#include "generator/output/sha256.hpp"
#include "generator/xacro/packages.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// The nearest folder at or above `folder` that is a ROS package; empty when there is none.
fs::path package_of(fs::path folder) {
  for (; !folder.empty() && folder != folder.root_path(); folder = folder.parent_path()) {
    if (fs::exists(folder / "package.xml")) return folder;
  }
  return {};
}

std::string manifest_name(const fs::path& path, const fs::path& input_folder, const fs::path& data_dir,
                          const files::Access& access) {
  const fs::path file = fs::weakly_canonical(path);
  if (const auto builtin = inside(file, fs::weakly_canonical(data_dir / "schemas")))
    return "builtin:" + builtin->generic_string();
  if (const auto near = inside(file, fs::weakly_canonical(input_folder))) return near->generic_string();
  const fs::path package = package_of(file.parent_path());
  if (package.empty()) return file.lexically_relative(fs::weakly_canonical(input_folder)).generic_string();
  const std::string name = xacro::package_name(package, access);
  return "package://" + (name.empty() ? package.filename().string() : name) + "/" +
         file.lexically_relative(package).generic_string();
}

}  // namespace

std::vector<HashedFile> input_files(const Sources& sources, const std::string& input_folder,
                                    const std::string& data_dir) {
  std::vector<HashedFile> files;
  for (const SourceFile& file : sources.files()) {
    const bool is_stdin = file.path.empty() || file.path == "-";
    const auto bytes = is_stdin ? std::optional(file.text) : sources.access().read(file.path, xml::kMaxFileSize);
    files.push_back({is_stdin ? "stdin" : manifest_name(file.path, input_folder, data_dir, sources.access()),
                     sha256(bytes.value_or(file.text))});
  }
  std::sort(files.begin(), files.end(), [](const HashedFile& a, const HashedFile& b) { return a.name < b.name; });
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace finemote::gen
