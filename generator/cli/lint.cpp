// finemote lint: warnings that save robots, and fixing what can be fixed mechanically.
#include "generator/lint/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/edited_file.hpp"
#include "generator/cli/lint_fix.hpp"
#include "generator/cli/robot_input.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// The file that fixes change; null when there are none.
const SourceFile* edited_file(const std::vector<Fix>& fixes) {
  for (const Fix& fix : fixes) {
    if (!fix.change.edits.empty()) return fix.change.edits.front().file;
  }
  return nullptr;
}

std::size_t count_fixable(const std::vector<Fix>& fixes) {
  return static_cast<std::size_t>(
      std::count_if(fixes.begin(), fixes.end(), [](const Fix& fix) { return !fix.change.edits.empty(); }));
}

/// The findings, with the reason at each that was not fixed.
Diagnostics with_reasons(const Diagnostics& findings, const AppliedFixes& applied) {
  Diagnostics result;
  for (Diagnostic finding : findings.in_file_order()) {
    for (const auto& [fix, reason] : applied.refused) {
      if (fix->code == finding.code && fix->message == finding.message) finding.note("not fixed: " + reason);
    }
    result.add(finding);
  }
  return result;
}

std::string outcome_text(const Diagnostics& findings, const std::string& name, const AppliedFixes& applied,
                         std::size_t fixable) {
  std::string text;
  for (const Fix* fix : applied.fixed) text += fmt::format("fixed {}: {}\n", name, fix->message);
  text += fmt::format("{} finding{}\n", findings.size(), findings.size() == 1 ? "" : "s");
  if (fixable > 0) text += "run 'finemote lint --fix' to fix the mechanical ones\n";
  return text;
}

/// What is left to find, which settles the exit status: kExitNo when one is denied.
Answer answer_of(const Options& options, const Diagnostics& findings, const std::string& name,
                 const AppliedFixes& applied, std::size_t fixable) {
  const bool denied = is_refused(options, findings);
  const std::vector<std::string> names(applied.fixed.empty() ? 0 : 1, name);
  Answer answer{denied ? kExitNo : kExitYes};
  if (!options.quiet) answer.text = outcome_text(findings, name, applied, fixable);
  answer.document = {{"schema", "finemote.lint/1"}, {"findings", findings.size()}, {"mended", names}};
  answer.judged = findings;
  return answer;
}

/// Fixes what can be fixed, in the file, and goes on with the robot, its texts and what is said of them as they are
/// then.
Answer fix_and_answer(const Options& options, const Input& input, const Linted& linted, Sources& sources,
                      Diagnostics& diagnostics) {
  const SourceFile* file = edited_file(linted.fixes);
  const auto mark = file == nullptr ? std::optional<std::string>("") : mark_before(*file, sources, diagnostics);
  if (!mark) return no_answer();
  const AppliedFixes applied = apply_fixes(options, input, linted, sources, diagnostics);
  if (!applied.edited) return answer_of(options, with_reasons(linted.findings, applied), {}, applied, 0);
  const std::string path = file->path;
  if (!write_result(path, *mark + applied.edited->text, diagnostics)) return no_answer();
  Answer answer = answer_of(options, with_reasons(applied.edited->linted->findings, applied), path, applied, 0);
  sources = std::move(applied.edited->sources);
  diagnostics = std::move(applied.edited->diagnostics);
  return answer;
}

}  // namespace

Answer run_lint(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  input->without_timing_file = options.fix;  // it would be of the robot before
  auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  const auto linted = lint_planned(options, std::move(*planned), diagnostics);
  if (!linted) return no_answer();
  if (options.fix) return fix_and_answer(options, *input, *linted, sources, diagnostics);
  return answer_of(options, linted->findings, {}, {}, count_fixable(linted->fixes));
}

}  // namespace finemote::gen
