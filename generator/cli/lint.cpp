// finemote lint: warnings that save robots, and mending what can be mended mechanically.
#include "generator/lint/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/lint_options.hpp"
#include "generator/cli/load.hpp"
#include "generator/cli/mend.hpp"
#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/code_output.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/lint/rules.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// `FM3151` or `3151`: one of lint's own codes.
std::vector<Code> codes(Context& context, const char* option, const std::vector<std::string>& words) {
  std::vector<Code> list;
  std::vector<std::string> names;
  for (const Rule& rule : lint_rules_by_number()) names.push_back(code_name(rule.code));
  for (const std::string& word : words) {
    const auto code = parse_code(word);
    if (code && is_lint_code(*code)) {
      list.push_back(*code);
    } else {
      context.diagnostics.error(code::usage, {}, fmt::format("{} '{}' is not a lint code", option, word))
          .hint(did_you_mean(word, names));
    }
  }
  return list;
}

/// What is on disk before the text of the robot; none, and FM5012, where that is not the text that was checked.
std::optional<std::string> mark_before(Context& context, const SourceFile& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const auto bytes = file.path.empty() ? std::nullopt : read_bytes(file.path);
  if (bytes == file.text) return "";
  if (bytes && *bytes == std::string(kByteOrderMark) + file.text) return std::string(kByteOrderMark);
  auto& finding =
      context.diagnostics.error(code::file_not_editable, {context.sources.add({file.name, file.path, {}})},
                                fmt::format("cannot edit '{}': {}", file.name,
                                            file.path.empty() ? "it is no file"
                                                              : "it is not in UTF-8, or changed while it was "
                                                                "checked"));
  finding.hint(file.path.empty() ? "save it, and give the name of the file" : "save the file as UTF-8");
  return std::nullopt;
}

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

void print_outcome(Context& context, const Diagnostics& findings, const std::string& name, const Mended& mended,
                   std::size_t fixable) {
  if (context.options.format != Format::text || context.options.quiet) return;
  for (const Fix* fix : mended.fixed) context.out << fmt::format("fixed {}: {}\n", name, fix->message);
  context.out << fmt::format("{} finding{}\n", findings.size(), findings.size() == 1 ? "" : "s");
  if (fixable > 0) context.out << "run 'finemote lint --fix' to fix the mechanical ones\n";
}

/// Prints what is left to find, and settles the exit status: kExitNo when one is denied.
int finish_lint(Context& context, const Diagnostics& findings, const std::string& name, const Mended& mended,
                std::size_t fixable) {
  const bool denied = findings.has_errors() || (context.options.warnings_are_errors && findings.size() > 0);
  print_outcome(context, findings, name, mended, fixable);
  const std::vector<std::string> names(mended.fixed.empty() ? 0 : 1, name);
  return finish_with(context, denied ? kExitNo : kExitYes, findings,
                     Json{{"schema", "finemote.lint/1"}, {"findings", findings.size()}, {"mended", names}});
}

/// Fixes what can be fixed, in the file, and goes on with the robot as it is then.
int fix_and_finish(Context& context, const Linted& linted) {
  const SourceFile* file = edited_file(linted.fixes);
  const auto mark = file == nullptr ? std::optional<std::string>("") : mark_before(context, *file);
  if (!mark) return finish(context, kExitInvalid);
  const Mended mended = mend(context, linted);
  if (!mended.edited) return finish_lint(context, with_reasons(linted.findings, mended), {}, mended, 0);
  if (!write_result(context, file->path, *mark + mended.edited->text)) return finish(context, kExitInvalid);
  Context edited{context.options, mended.edited->sources, mended.edited->diagnostics, context.out, context.err};
  return finish_lint(edited, with_reasons(mended.edited->linted->findings, mended), file->path, mended, 0);
}

}  // namespace

LintOptions lint_options(Context& context, const Verdict& verdict) {
  LintOptions options;
  options.allow = codes(context, "--allow", context.options.allow);
  options.deny = codes(context, "--deny", context.options.deny);
  options.bus_load = verdict.bus_load;
  options.overloads = verdict.overloads;
  options.command_ages = verdict.command_ages;
  return options;
}

int run_lint(Context& context) {
  auto loaded = load_robot(context);
  if (!loaded) return finish(context, kExitInvalid);
  const auto linted = lint_loaded(context, std::move(*loaded));
  if (!linted) return finish(context, kExitInvalid);
  if (context.options.fix) return fix_and_finish(context, *linted);
  return finish_lint(context, linted->findings, {}, {}, count_fixable(linted->fixes));
}

}  // namespace finemote::gen
