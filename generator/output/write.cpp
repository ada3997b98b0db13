#include "generator/output/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Files written under temporary names; those not renamed by commit() vanish with the object.
class Staging {
 public:
  explicit Staging(fs::path root) : root_(std::move(root)) {}
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    for (const std::string& name : names_) fs::remove(temporary(name), ignored);
  }

  void add(const std::string& name, const std::string& text) {
    fs::create_directories((root_ / name).parent_path());
    names_.push_back(name);
    std::ofstream file(temporary(name), std::ios::binary | std::ios::trunc);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) throw fs::filesystem_error("cannot write", root_ / name, std::make_error_code(std::errc::io_error));
  }

  void commit() {
    for (const std::string& name : names_) fs::rename(temporary(name), root_ / name);
    names_.clear();
  }

 private:
  fs::path temporary(const std::string& name) const { return root_ / (name + ".finemote-tmp"); }

  fs::path root_;
  std::vector<std::string> names_;
};

bool lists(const Manifest& manifest, const std::string& name) {
  return std::any_of(manifest.outputs.begin(), manifest.outputs.end(),
                     [&](const HashedFile& file) { return file.name == name; });
}

void remove_files(const fs::path& root, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    fs::remove(root / name);
    std::error_code not_empty;
    const fs::path parent = (root / name).parent_path();
    if (parent != root) fs::remove(parent, not_empty);  // an emptied folder of ours goes as well
  }
}

}  // namespace

WriteResult write_output(const std::string& folder, const Output& output, bool dry_run, Diagnostics& diagnostics) {
  WriteResult result;
  const auto previous = open_folder(folder, output, diagnostics);
  if (diagnostics.has_errors()) return result;
  const fs::path root(folder);
  std::vector<OutputFile> files = output.files;
  files.push_back({kManifestName, manifest_text(output.manifest)});
  for (const OutputFile& file : files) {
    const bool same = read_bytes((root / file.name).string()) == file.text;
    (same ? result.unchanged : result.written).push_back(file.name);
  }
  if (previous) {
    for (const HashedFile& file : previous->outputs) {
      const bool gone = !lists(output.manifest, file.name) && fs::exists(root / file.name);
      if (gone) result.removed.push_back(file.name);
    }
  }
  if (dry_run) return result;

  try {
    Staging staging(root);
    for (const OutputFile& file : files) {
      if (std::find(result.written.begin(), result.written.end(), file.name) != result.written.end()) {
        staging.add(file.name, file.text);
      }
    }
    remove_files(root, result.removed);
    staging.commit();
  } catch (const fs::filesystem_error& error) {
    diagnostics.error(code::output_not_writable, {},
                      fmt::format("cannot write '{}': {}", error.path1().generic_string(), error.code().message()));
  }
  return result;
}

}  // namespace finemote::gen
