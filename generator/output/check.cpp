#include "generator/output/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "generator/diagnostic/code_output.hpp"
#include "generator/output/lock.hpp"
#include "generator/output/sha256.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> by_name(const std::vector<HashedFile>& files) {
  std::map<std::string, std::string> map;
  for (const HashedFile& file : files) map[file.name] = file.sha256;
  return map;
}

/// Which inputs changed since the manifest was written; empty: none.
std::string changed_inputs(const Manifest& previous, const Manifest& now) {
  const auto before = by_name(previous.inputs);
  const auto after = by_name(now.inputs);
  std::string names;
  const auto add = [&](const std::string& name, const char* what) {
    names += fmt::format("{}'{}' {}", names.empty() ? "" : ", ", name, what);
  };
  for (const auto& [name, hash] : after) {
    const auto found = before.find(name);
    if (found != before.end() && found->second != hash) add(name, "changed");
  }
  for (const auto& [name, hash] : after) {
    if (before.count(name) == 0) add(name, "is new");
  }
  for (const auto& [name, hash] : before) {
    if (after.count(name) == 0) add(name, "is gone");
  }
  return names;
}

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "no options" : fmt::format("{}", fmt::join(words, " "));
}

/// What is not as it was when the manifest was written: inputs and options; empty: nothing.
std::string changed_question(const Manifest& previous, const Manifest& now) {
  std::string reason = changed_inputs(previous, now);
  if (previous.options != now.options) {
    reason += fmt::format("{}generated with {}, checked with {}", reason.empty() ? "" : "; ", joined(previous.options),
                          joined(now.options));
  }
  return reason;
}

/// Why the output should be different now, as far as that can be known; `beyond` where nothing of it has changed.
std::string changes(const Manifest& previous, const Manifest& now, const std::string& beyond) {
  std::string reason = changed_question(previous, now);
  if (previous.tool != now.tool)
    reason += fmt::format("{}written by {}, checked with {}", reason.empty() ? "" : "; ", previous.tool, now.tool);
  return reason.empty() ? beyond : reason;
}

/// Why generate would write the manifest anew where every other file is as it should be; empty: it would not, or for
/// another version of the tool alone.
std::string manifest_change(const Folder& folder, const Output& output) {
  if (read_bytes((folder.root / kManifestName).string()) == manifest_text(output.manifest)) return {};
  const std::string reason = changed_question(folder.previous, output.manifest);
  if (!reason.empty() || folder.previous.tool != output.manifest.tool) return reason;
  return fmt::format("'{}' was edited", kManifestName);
}

/// What the CR of a file that differs by them alone are.
std::string words_for_returns(const std::string& text) {
  for (std::size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1)) {
    const std::size_t next = text.find_first_not_of('\r', at);
    if (next != std::string::npos && text[next] != '\n') return "has CR characters that were not generated";
  }
  return "has CR line ends; generated files have LF";
}

class Checker {
 public:
  Checker(const Folder& folder, const Output& output, const std::string& beyond)
      : root_(folder.root),
        has_manifest_(folder.memory == Folder::Memory::complete),
        listed_(by_name(folder.previous.outputs)),
        wanted_(by_name(output.manifest.outputs)),
        why_(has_manifest_ ? changes(folder.previous, output.manifest, beyond) : "nothing was generated here") {}

  /// Why files are not what they were.
  [[nodiscard]] const std::string& why() const { return why_; }

  std::vector<Finding> run(const Folder& folder, const Output& output) {
    const Manifest& previous = folder.previous;
    if (folder.memory == Folder::Memory::none) add_changed(Finding::State::missing, kManifestName);
    if (folder.memory == Folder::Memory::broken)
      add(Finding::State::hand_edited, kManifestName, "cannot be used: what was generated is not known");
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

  /// One that is not what it was because of what has changed.
  void add_changed(Finding::State state, const std::string& file, std::string reason = {}) {
    findings_.push_back({state, file, std::move(reason), true});
  }

  /// One file: the disk against the manifest, then the manifest against a fresh run.
  void compare(const std::string& name) {
    const auto wanted = wanted_.find(name);
    const auto listed = listed_.find(name);
    const auto text = read_bytes((root_ / name).string());
    if (listed == listed_.end()) return compare_unlisted(name, text, wanted->second);
    if (!text) return add(Finding::State::missing, name, "listed in the manifest, but not there");
    const std::string hash = sha256(*text);
    const bool is_right = wanted != wanted_.end() && wanted->second == hash;
    if (is_right && hash != listed->second)
      return add(Finding::State::stale, name, "is what would be generated, but not what the manifest lists");
    if (hash != listed->second) {
      const std::string plain = sha256(without_carriage_returns(*text));
      const bool only_endings = plain == listed->second || (wanted != wanted_.end() && plain == wanted->second);
      return only_endings ? add(Finding::State::line_endings, name, words_for_returns(*text))
                          : add(Finding::State::hand_edited, name, "differs from what was generated");
    }
    if (wanted == wanted_.end()) return add_changed(Finding::State::stale, name, "would no longer be generated");
    if (wanted->second != listed->second) add_changed(Finding::State::stale, name);
  }

  void compare_unlisted(const std::string& name, const std::optional<std::string>& text, const std::string& wanted) {
    if (!text && has_manifest_) return add_changed(Finding::State::missing, name, "would be new");
    if (!text) return add(Finding::State::missing, name, "not there");
    const bool is_same = sha256(*text) == wanted;
    if (is_same && has_manifest_) add(Finding::State::stale, name, "not in the manifest");
    if (is_same) return;
    if (sha256(without_carriage_returns(*text)) == wanted)
      return add(Finding::State::line_endings, name, words_for_returns(*text));
    add(Finding::State::hand_edited, name, "not in the manifest, and not what would be generated");
  }

  /// Names of files that `generate --force` kept, or that a killed run left.
  static bool is_left_over(const std::string& name) {
    return name.find(".orig") != std::string::npos || name.find(kTemporaryMark) != std::string::npos;
  }

  static bool carries_our_header(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string line;
    std::getline(file, line);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line == kGeneratedHeader;
  }

  /// Whether a manifest or this run has a file of this name, in whatever case the file system has kept it.
  [[nodiscard]] bool is_known(const std::string& name) const {
    if (listed_.count(name) > 0 || wanted_.count(name) > 0) return true;
    return std::any_of(wanted_.begin(), wanted_.end(),
                       [&](const auto& file) { return is_one_file(root_, file.first, name); });
  }

  void find_orphans() {
    std::error_code error;
    std::vector<std::string> orphans;
    for (fs::recursive_directory_iterator entry(root_, error), end; !error && entry != end; entry.increment(error)) {
      if (is_left_over(entry->path().filename().string())) continue;
      if (!entry->is_regular_file(error) || !carries_our_header(entry->path())) continue;
      const std::string name = entry->path().lexically_relative(root_).generic_string();
      if (!is_known(name)) orphans.push_back(name);
    }
    std::sort(orphans.begin(), orphans.end());
    for (const std::string& name : orphans)
      add(Finding::State::orphan, name, "carries our header, not in the manifest");
  }

  fs::path root_;
  bool has_manifest_;
  std::map<std::string, std::string> listed_, wanted_;
  std::string why_;
  std::vector<Finding> findings_;
};

struct StateWords {
  const char* name;
  const char* predicate;  ///< what a file in this state is, in a sentence
  Code code;
};

StateWords words_of(Finding::State state) {
  switch (state) {
    case Finding::State::missing:
      return {"missing", "missing", code::output_missing};
    case Finding::State::hand_edited:
      return {"hand-edited", "edited by hand", code::output_edited};
    case Finding::State::line_endings:
      return {"line-endings", "changed in its line ends", code::output_line_ends};
    case Finding::State::stale:
      return {"stale", "stale", code::output_stale};
    case Finding::State::orphan:
      return {"orphan", "an orphan", code::output_orphan};
    case Finding::State::stale_timing:
      break;
  }
  return {"stale-timing", "stale", code::timing_stale};
}

}  // namespace

const char* state_name(Finding::State state) { return words_of(state).name; }

std::string CheckResult::reason_of(const Finding& finding) const {
  if (!finding.follows_change) return finding.reason;
  return finding.reason.empty() ? change : finding.reason + ": " + change;
}

CheckResult check_output(const std::string& folder, const Output& output, const std::string& beyond,
                         Diagnostics& diagnostics) {
  CheckResult result;
  const FolderLock lock(folder_path(folder), FolderLock::Use::look, diagnostics);
  if (diagnostics.has_errors()) return result;
  const auto found = open_folder(folder, output, {}, diagnostics);
  if (!found) return result;
  Checker checker(*found, output, beyond);
  result.findings = checker.run(*found, output);
  result.change = checker.why();
  result.previous_tool = found->previous.tool;
  if (result.findings.empty()) result.manifest_change = manifest_change(*found, output);
  result.tool_changed = result.findings.empty() && result.previous_tool != output.manifest.tool;
  return result;
}

Diagnostics as_diagnostics(const std::string& folder, const CheckResult& result, Sources& sources) {
  Diagnostics diagnostics;
  for (const Finding& finding : result.findings) {
    if (finding.state == Finding::State::stale_timing) continue;  // FM4022 has said it
    const std::string path = (folder_path(folder) / finding.file).generic_string();
    const StateWords words = words_of(finding.state);
    diagnostics.error(words.code, {sources.add({path, path, {}})},
                      fmt::format("'{}' is {}: {}", finding.file, words.predicate, result.reason_of(finding)));
  }
  return diagnostics;
}

}  // namespace finemote::gen
