#include "generator/output/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "generator/output/sha256.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

std::string without_carriage_returns(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

std::map<std::string, std::string> by_name(const std::vector<HashedFile>& files) {
  std::map<std::string, std::string> map;
  for (const HashedFile& file : files) map[file.name] = file.sha256;
  return map;
}

/// Why the output should be different now: which inputs changed since the manifest was written.
std::string changed_inputs(const Manifest& previous, const Manifest& now) {
  const auto before = by_name(previous.inputs);
  const auto after = by_name(now.inputs);
  std::string names;
  const auto add = [&](const std::string& name, const char* what) {
    names += fmt::format("{}'{}' {}", names.empty() ? "" : ", ", name, what);
  };
  for (const auto& [name, hash] : after) {
    const auto found = before.find(name);
    if (found == before.end()) {
      add(name, "is new");
    } else if (found->second != hash) {
      add(name, "changed");
    }
  }
  for (const auto& [name, hash] : before) {
    if (after.count(name) == 0) add(name, "is gone");
  }
  if (!names.empty()) return names;
  return previous.tool == now.tool ? "the generator writes it differently" : "written by " + previous.tool;
}

class Checker {
 public:
  Checker(const std::string& folder, const Output& output, const Manifest& previous)
      : root_(folder),
        listed_(by_name(previous.outputs)),
        wanted_(by_name(output.manifest.outputs)),
        why_(changed_inputs(previous, output.manifest)) {}

  std::vector<Finding> run(const Manifest& previous, const Output& output) {
    for (const HashedFile& file : output.manifest.outputs) compare(file.name);
    for (const HashedFile& file : previous.outputs) {
      if (wanted_.count(file.name) == 0) compare(file.name);
    }
    find_orphans();
    return std::move(findings_);
  }

 private:
  void add(Finding::State state, const std::string& file, std::string reason) {
    findings_.push_back({state, file, std::move(reason)});
  }

  /// One file: the disk against the manifest, then the manifest against a fresh run.
  void compare(const std::string& name) {
    const auto wanted = wanted_.find(name);
    const auto listed = listed_.find(name);
    const auto text = read_bytes((root_ / name).string());
    if (listed == listed_.end()) {
      if (text && sha256(*text) == wanted->second) return add(Finding::State::stale, name, "not in the manifest");
      return text ? add(Finding::State::hand_edited, name, "not in the manifest, and not what would be generated")
                  : add(Finding::State::missing, name, "would be new: " + why_);
    }
    if (!text) return add(Finding::State::missing, name, "listed in the manifest, but not there");
    if (sha256(*text) != listed->second) {
      const bool only_endings = sha256(without_carriage_returns(*text)) == listed->second;
      return only_endings ? add(Finding::State::line_endings, name, "has CR line ends; generated files have LF")
                          : add(Finding::State::hand_edited, name, "differs from what was generated");
    }
    if (wanted == wanted_.end()) return add(Finding::State::stale, name, "would no longer be generated: " + why_);
    if (wanted->second != listed->second) add(Finding::State::stale, name, why_);
  }

  static bool carries_our_header(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string line;
    std::getline(file, line);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line == kGeneratedHeader;
  }

  void find_orphans() {
    std::error_code error;
    std::vector<std::string> orphans;
    for (fs::recursive_directory_iterator entry(root_, error), end; !error && entry != end; entry.increment(error)) {
      if (!entry->is_regular_file(error) || !carries_our_header(entry->path())) continue;
      const std::string name = entry->path().lexically_relative(root_).generic_string();
      if (listed_.count(name) == 0 && wanted_.count(name) == 0) orphans.push_back(name);
    }
    std::sort(orphans.begin(), orphans.end());
    for (const std::string& name : orphans)
      add(Finding::State::orphan, name, "carries our header, not in the manifest");
  }

  fs::path root_;
  std::map<std::string, std::string> listed_, wanted_;
  std::string why_;
  std::vector<Finding> findings_;
};

}  // namespace

const char* state_name(Finding::State state) {
  switch (state) {
    case Finding::State::missing:
      return "missing";
    case Finding::State::hand_edited:
      return "hand-edited";
    case Finding::State::line_endings:
      return "line-endings";
    case Finding::State::stale:
      return "stale";
    case Finding::State::orphan:
      return "orphan";
  }
  return "";
}

CheckResult check_output(const std::string& folder, const Output& output, Diagnostics& diagnostics) {
  CheckResult result;
  const auto previous = open_folder(folder, output, diagnostics);
  if (diagnostics.has_errors()) return result;
  if (!previous) {
    result.findings.push_back({Finding::State::missing, kManifestName, "nothing was generated here"});
    for (const OutputFile& file : output.files) {
      if (!read_bytes(folder + "/" + file.name))
        result.findings.push_back({Finding::State::missing, file.name, "not there"});
    }
    return result;
  }
  result.findings = Checker(folder, output, *previous).run(*previous, output);
  result.previous_tool = previous->tool;
  result.tool_changed = result.findings.empty() && previous->tool != output.manifest.tool;
  return result;
}

}  // namespace finemote::gen
