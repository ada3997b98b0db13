#include "generator/output/write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "generator/diagnostic/code_output.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/output/lock.hpp"
#include "generator/output/ownership.hpp"
#include "generator/output/replacement.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

bool lists(const Manifest& manifest, const std::string& name) {
  return std::any_of(manifest.outputs.begin(), manifest.outputs.end(),
                     [&](const HashedFile& file) { return file.name == name; });
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// `NAME.orig`, or the first of `NAME.orig.2`, `NAME.orig.3`... that is free.
std::string free_name(const fs::path& root, const std::string& name) {
  std::error_code ignored;
  std::string candidate = name + ".orig";
  for (int number = 2; fs::exists(fs::symlink_status(root / candidate, ignored)); ++number)
    candidate = fmt::format("{}.orig.{}", name, number);
  return candidate;
}

/// A user's file where an output goes, or that the manifest lists for removal.
struct Obstacle {
  std::string name;
  bool was_ours = false;    ///< a manifest has it: it was edited since
  bool is_removed = false;  ///< no output takes its place
};

/// What is to be done to a folder; made by looking alone.
struct Steps {
  std::vector<OutputFile> files;  ///< all of them, the manifest last
  WriteResult result;
  std::vector<Obstacle> obstacles;
};

Steps plan_steps(const Folder& folder, const Output& output) {
  Steps steps;
  const Ownership ownership(folder, output);
  steps.files = output.files;
  for (const OutputFile& file : output.files) {
    const auto there = read_bytes((folder.root / file.name).string());
    (there == file.text ? steps.result.unchanged : steps.result.written).push_back(file.name);
    if (there && !ownership.is_ours(file.name, *there))
      steps.obstacles.push_back({file.name, ownership.is_listed(file.name), false});
  }
  const std::string manifest = manifest_text(output.manifest);
  const bool same = read_bytes((folder.root / kManifestName).string()) == manifest;
  (same ? steps.result.unchanged : steps.result.written).emplace_back(kManifestName);
  steps.files.push_back({kManifestName, manifest});
  for (const HashedFile& file : folder.previous.outputs) {
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(folder.root / file.name, ignored);
    const bool is_known = lists(output.manifest, file.name) || contains(steps.result.removed, file.name);
    // A folder of this name is not what was written: the file is gone.
    if (is_known || !fs::exists(status) || fs::is_directory(status)) continue;
    const auto there = fs::is_regular_file(status) ? read_bytes((folder.root / file.name).string()) : std::nullopt;
    if (there && ownership.is_ours(file.name, *there)) {
      steps.result.removed.push_back(file.name);
    } else {
      steps.obstacles.push_back({file.name, true, true});
    }
  }
  return steps;
}

/// Whether a file begins as generated sources do: a merge of two branches may have put it there.
bool is_generated(const fs::path& path) {
  const auto text = read_bytes(path.string());
  return text && text->rfind(kGeneratedHeader, 0) == 0;
}

void report(const Folder& folder, std::vector<Obstacle> obstacles, const std::string& way_out, Sources& sources,
            Diagnostics& diagnostics) {
  std::sort(obstacles.begin(), obstacles.end(), [](const Obstacle& a, const Obstacle& b) { return a.name < b.name; });
  for (const Obstacle& obstacle : obstacles) {
    const std::string path = (folder.root / obstacle.name).generic_string();
    auto& finding = diagnostics.error(
        code::file_of_the_user, {sources.add({path, path, {}})},
        fmt::format("'{}' {} and would be {}", obstacle.name,
                    obstacle.was_ours ? "was edited since finemote wrote it" : "was not written by finemote",
                    obstacle.is_removed ? "removed" : "overwritten"));
    if (&obstacle != &obstacles.back()) continue;
    const bool all_generated = std::all_of(obstacles.begin(), obstacles.end(),
                                           [&](const Obstacle& o) { return is_generated(folder.root / o.name); });
    const std::string path_of_folder = folder.root.generic_string();
    const std::string after_merge = fmt::format("; after a merge: rm -r '{}', then generate again", path_of_folder);
    finding.hint(way_out + (all_generated ? after_merge : ""));
  }
}

/// The names of files a killed run may have left unfinished.
std::vector<std::string> possible_names(const Folder& folder, const Output& output) {
  std::vector<std::string> names{kManifestName};
  for (const OutputFile& file : output.files) names.push_back(file.name);
  for (const HashedFile& file : folder.previous.outputs) names.push_back(file.name);
  return names;
}

void remove_emptied_folders(const fs::path& root, const std::vector<std::string>& names) {
  std::error_code not_empty;
  for (const std::string& name : names) {
    const fs::path parent = (root / name).parent_path();
    if (parent != root) fs::remove(parent, not_empty);
  }
}

void carry_out(const Folder& folder, const Output& output, const Steps& steps) {
  Replacement replacement(folder.root);
  replacement.clean_up(possible_names(folder, output));
  for (const OutputFile& file : steps.files) {
    if (contains(steps.result.written, file.name)) replacement.stage(file.name, file.text);
  }
  for (const auto& [name, to] : steps.result.moved) replacement.set_aside(name, to);
  for (const OutputFile& file : steps.files) {
    if (file.name != kManifestName && contains(steps.result.written, file.name)) replacement.put(file.name);
  }
  for (const std::string& name : steps.result.removed) replacement.take_away(name);
  if (contains(steps.result.written, kManifestName)) replacement.put(kManifestName);
  replacement.keep();
}

/// Reports FM5002, in the words of a run that writes, for the first folder that no file may be put into.
void check_writable(const fs::path& root, const Steps& steps, Diagnostics& diagnostics) {
  std::vector<std::string> names = steps.result.written;
  names.insert(names.end(), steps.result.removed.begin(), steps.result.removed.end());
  for (const std::string& name : names) {
    fs::path blocked = root / name, folder = blocked.parent_path();
    std::error_code ignored;
    for (; !folder.empty() && !fs::exists(folder, ignored); folder = folder.parent_path()) blocked = folder;
    if (::faccessat(AT_FDCWD, folder.empty() ? "." : folder.c_str(), W_OK | X_OK, AT_EACCESS) == 0) continue;
    const std::string reason = system_reason(errno);
    const char* what = fs::exists(root, ignored) ? "write" : "create folder";
    diagnostics.error(code::output_not_writable, {},
                      fmt::format("cannot {} '{}': {}", what, blocked.generic_string(), reason));
    return;
  }
}

}  // namespace

WriteResult write_output(const std::string& folder, const Output& output, const WriteOptions& options, Sources& sources,
                         Diagnostics& diagnostics) {
  const fs::path root = folder_path(folder);
  if (!check_root(root, diagnostics)) return {};
  FolderLock lock(root, options.dry_run ? FolderLock::Use::look : FolderLock::Use::write, diagnostics);
  if (diagnostics.has_errors()) return {};
  const auto found = open_folder(folder, output, {options.force, options.other_robot}, diagnostics);
  if (!found) return lock.remove_created(), WriteResult{};
  Steps steps = plan_steps(*found, output);
  for (const Obstacle& obstacle : steps.obstacles) {
    if (options.force) steps.result.moved.emplace_back(obstacle.name, free_name(root, obstacle.name));
  }
  if (!options.force) report(*found, std::move(steps.obstacles), options.way_out, sources, diagnostics);
  if (options.dry_run && !diagnostics.has_errors()) check_writable(root, steps, diagnostics);
  const bool refused = diagnostics.has_errors() || (options.warnings_are_errors && diagnostics.size() > 0);
  if (refused || options.dry_run) return lock.remove_created(), steps.result;
  try {
    carry_out(*found, output, steps);
  } catch (const fs::filesystem_error& error) {
    lock.remove_created();
    diagnostics.error(
        code::output_not_writable, {},
        fmt::format("cannot write '{}': {}", error.path1().generic_string(), system_reason(error.code().value())));
    return {};
  }
  remove_emptied_folders(root, steps.result.removed);
  return steps.result;
}

}  // namespace finemote::gen
