#include "generator/output/unified_diff.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdlib>
#include <dtl/dtl.hpp>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "generator/output/check.hpp"

namespace finemote::gen {
namespace {

using Lines = std::vector<std::string>;

/// The last one says so where it has no line break, as `diff` does.
Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  if (!lines.empty() && text.back() != '\n') lines.back() += "\n\\ No newline at end of file";
  return lines;
}

/// Whether too many lines differ to compare them in a short time, which grows with the square of their number.
bool is_rewritten(const Lines& before, const Lines& after) {
  constexpr std::size_t kMost = 4'000;
  std::unordered_map<std::string_view, std::ptrdiff_t> left;
  for (const std::string& line : before) ++left[line];
  for (const std::string& line : after) --left[line];
  std::size_t different = 0;
  for (const auto& [line, count] : left) different += static_cast<std::size_t>(std::abs(count));
  return different > kMost;
}

void print_rewritten(const Lines& before, const Lines& after, std::ostream& out) {
  const auto range = [](const Lines& lines) { return fmt::format("{},{}", lines.empty() ? 0 : 1, lines.size()); };
  out << "@@ -" << range(before) << " +" << range(after) << " @@\n";
  for (const std::string& line : before) out << '-' << line << '\n';
  for (const std::string& line : after) out << '+' << line << '\n';
}

void print_hunks(const Lines& before, const Lines& after, std::ostream& out) {
  dtl::Diff<std::string> diff(before, after);
  diff.onHuge();
  diff.compose();
  diff.composeUnifiedHunks();
  diff.printUnifiedFormat(out);
}

const OutputFile* find_file(const Output& output, const std::string& name) {
  for (const OutputFile& file : output.files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

}  // namespace

std::string unified_diff(const std::string& old_name, const std::string& old_text, const std::string& new_name,
                         const std::string& new_text) {
  if (old_text == new_text) return {};
  const Lines before = lines_of(old_text), after = lines_of(new_text);
  std::ostringstream text;
  text << "--- " << old_name << "\n+++ " << new_name << "\n";
  (is_rewritten(before, after) ? print_rewritten : print_hunks)(before, after, text);
  return text.str();
}

std::string unified_diff(const std::string& folder, const Output& output, const CheckResult& result) {
  std::string text;
  for (const Finding& finding : result.findings) {
    if (finding.file == kManifestName) continue;
    const auto on_disk = read_bytes(folder + "/" + finding.file);
    const OutputFile* fresh = find_file(output, finding.file);
    if (finding.state == Finding::State::orphan) continue;
    text += unified_diff(on_disk ? "a/" + finding.file : "/dev/null", on_disk.value_or(""),
                         fresh ? "b/" + finding.file : "/dev/null", fresh ? fresh->text : "");
  }
  return text;
}

}  // namespace finemote::gen
