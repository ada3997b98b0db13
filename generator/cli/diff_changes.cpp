#include "generator/cli/diff_changes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;
using ChangeKind = ModelChange::Kind;

/// First words of subjects in the order in which they are shown.
constexpr std::string_view kOrder[] = {"robot",  "device", "expander", "bus",  "requirement",
                                       "bounds", "size",   "link",     "joint"};

std::size_t place_of(const ModelChange& change) {
  const std::string word = change.subject.substr(0, change.subject.find(' '));
  return static_cast<std::size_t>(std::find(std::begin(kOrder), std::end(kOrder), word) - std::begin(kOrder));
}

void compare(const std::string& subject, const Properties& before, const Properties& after,
             std::vector<ModelChange>& changes) {
  for (const auto& [property, value] : before) {
    const auto found = after.find(property);
    const std::string now = found == after.end() ? "none" : found->second;
    if (now != value) changes.push_back({ChangeKind::changed, subject, property, value, now});
  }
  for (const auto& [property, value] : after) {
    if (before.count(property) == 0) changes.push_back({ChangeKind::changed, subject, property, "none", value});
  }
}

/// As a table of Markdown takes it.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("|<>*_`\\[]").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// `text` up to the end of a line before `most` bytes.
std::string cut(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const std::size_t end = text.rfind('\n', most) + 1;
  const auto lines = std::count(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), '\n');
  return text.substr(0, end) + fmt::format("... {} more lines\n", lines);
}

/// A fence longer than any row of backquotes in the text.
std::string fence_of(const std::string& text) {
  std::size_t longest = 2;
  for (std::size_t at = text.find('`'); at != std::string::npos; at = text.find('`', at)) {
    const std::size_t end = std::min(text.find_first_not_of('`', at), text.size());
    longest = std::max(longest, end - at);
    at = end;
  }
  return std::string(longest + 1, '`');
}

}  // namespace

std::vector<ModelChange> changes_of(const Facts& before, const Facts& after) {
  std::vector<ModelChange> changes;
  if (before.empty() || after.empty()) return changes;  // a generated folder: its text alone
  for (const auto& [subject, properties] : before) {
    const auto found = after.find(subject);
    if (found == after.end())
      changes.push_back({ChangeKind::removed, subject, {}, {}, {}});
    else
      compare(subject, properties, found->second, changes);
  }
  for (const auto& [subject, properties] : after) {
    if (before.count(subject) == 0) changes.push_back({ChangeKind::added, subject, {}, {}, {}});
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const ModelChange& a, const ModelChange& b) { return place_of(a) < place_of(b); });
  return changes;
}

std::string line_of(const ModelChange& change) {
  if (change.kind == ChangeKind::added) return change.subject + ": added";
  if (change.kind == ChangeKind::removed) return change.subject + ": removed";
  return fmt::format("{}: {} {} -> {}", change.subject, change.property, change.before, change.after);
}

Json json_of(const ModelChange& change) {
  const bool is_value = change.kind == ChangeKind::changed;
  const auto value = [is_value](const std::string& text) { return is_value ? Json(text) : Json(nullptr); };
  constexpr const char* kWords[] = {"added", "removed", "changed"};
  return {{"change", kWords[static_cast<int>(change.kind)]},
          {"subject", change.subject},
          {"property", value(change.property)},
          {"before", value(change.before)},
          {"after", value(change.after)}};
}

std::string markdown_of(const std::vector<ModelChange>& changes, const std::string& remark,
                        const std::string& text_diff) {
  constexpr std::size_t kMostTable = 30'000, kMostText = 30'000;  // a comment on GitHub holds 65536
  if (changes.empty() && text_diff.empty()) return "The robot and its generated files are the same.\n";
  std::string text;
  if (!changes.empty()) {
    std::string rows;
    for (const ModelChange& change : changes) {
      const std::string what =
          change.kind == ChangeKind::added ? "added | |"
          : change.kind == ChangeKind::removed
              ? "removed | |"
              : fmt::format("{} | {} | {}", cell(change.property), cell(change.before), cell(change.after));
      rows += fmt::format("| {} | {} |\n", cell(change.subject), what);
    }
    text = "| | change | before | after |\n|---|---|---|---|\n" + cut(rows, kMostTable);
  }
  if (!remark.empty()) text += "\n" + remark;
  if (text_diff.empty()) return text;
  const std::string fence = fence_of(text_diff);
  return text + fmt::format("{}<details><summary>Generated files</summary>\n\n{}diff\n{}{}\n\n</details>\n",
                            text.empty() ? "" : "\n", fence, cut(text_diff, kMostText), fence);
}

}  // namespace finemote::gen
