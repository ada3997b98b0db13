// finemote lint: warnings that save robots, and mending what can be mended mechanically.
#include "generator/lint/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/edited_file.hpp"
#include "generator/cli/mend.hpp"
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
Diagnostics with_reasons(const Diagnostics& findings, const Mended& mended) {
  Diagnostics result;
  for (Diagnostic finding : findings.in_file_order()) {
    for (const auto& [fix, reason] : mended.refused) {
      if (fix->code == finding.code && fix->message == finding.message) finding.note("not fixed: " + reason);
    }
    result.add(finding);
  }
  return result;
}

std::string outcome_text(const Diagnostics& findings, const std::string& name, const Mended& mended,
                         std::size_t fixable) {
  std::string text;
  for (const Fix* fix : mended.fixed) text += fmt::format("fixed {}: {}\n", name, fix->message);
  text += fmt::format("{} finding{}\n", findings.size(), findings.size() == 1 ? "" : "s");
  if (fixable > 0) text += "run 'finemote lint --fix' to fix the mechanical ones\n";
  return text;
}

/// What is left to find, which settles the exit status: kExitNo when one is denied.
Answer answer_of(const Options& options, const Diagnostics& findings, const std::string& name, const Mended& mended,
                 std::size_t fixable) {
  const bool denied = is_refused(options, findings);
  const std::vector<std::string> names(mended.fixed.empty() ? 0 : 1, name);
  Answer answer{denied ? kExitNo : kExitYes};
  if (!options.quiet) answer.text = outcome_text(findings, name, mended, fixable);
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
  const Mended mended = mend(options, input, linted, sources, diagnostics);
  if (!mended.edited) return answer_of(options, with_reasons(linted.findings, mended), {}, mended, 0);
  const std::string path = file->path;
  if (!write_result(path, *mark + mended.edited->text, diagnostics)) return no_answer();
  Answer answer = answer_of(options, with_reasons(mended.edited->linted->findings, mended), path, mended, 0);
  sources = std::move(mended.edited->sources);
  diagnostics = std::move(mended.edited->diagnostics);
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
