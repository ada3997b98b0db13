#include "generator/output/unified_diff.hpp"

#include <dtl/dtl.hpp>
#include <sstream>
#include <vector>

#include "generator/output/check.hpp"

namespace finemote::gen {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
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
  dtl::Diff<std::string> diff(lines_of(old_text), lines_of(new_text));
  diff.onHuge();
  diff.compose();
  diff.composeUnifiedHunks();
  std::ostringstream text;
  text << "--- " << old_name << "\n+++ " << new_name << "\n";
  diff.printUnifiedFormat(text);
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
