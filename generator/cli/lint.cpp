// finemote lint: warnings that save robots, and mending what can be mended mechanically.
#include "generator/lint/lint.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string_view>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/lint_options.hpp"
#include "generator/cli/load.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/code_output.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/suggest.hpp"
#include "generator/lint/codes.hpp"
#include "generator/output/folder.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// `FM3151` or `3151`: one of lint's own codes.
std::vector<Code> codes(Context& context, const char* option, const std::vector<std::string>& words) {
  std::vector<Code> list;
  std::vector<std::string> names;
  for (const Code code : kLintCodes) names.push_back(code_name(code));
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

/// What an edited file is to hold; none, and FM5012, where what is on disk is not the text that was checked.
std::optional<std::string> edited_bytes(Context& context, const SourceFile& file, const std::vector<Edit>& edits) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const auto bytes = file.path.empty() ? std::nullopt : read_bytes(file.path);
  if (bytes == file.text) return apply_edits(file, edits);
  if (bytes && *bytes == std::string(kByteOrderMark) + file.text)
    return std::string(kByteOrderMark) + apply_edits(file, edits);
  auto& finding =
      context.diagnostics.error(code::file_not_editable, {context.sources.add({file.name, file.path, {}})},
                                fmt::format("cannot edit '{}': {}", file.name,
                                            file.path.empty() ? "it is no file"
                                                              : "it is not in UTF-8, or changed while it was "
                                                                "checked"));
  finding.hint(file.path.empty() ? "save it, and give the name of the file" : "save the file as UTF-8");
  return std::nullopt;
}

/// Writes every edited file anew, or none; returns their names.
std::vector<std::string> write_edits(Context& context, const std::vector<Edit>& edits) {
  std::map<std::string, std::pair<const SourceFile*, std::vector<Edit>>> files;
  for (const Edit& edit : edits) {
    auto& [file, list] = files[edit.file->path];
    file = edit.file;
    list.push_back(edit);
  }
  std::map<std::string, std::string> texts;
  for (const auto& [path, entry] : files) {
    if (auto bytes = edited_bytes(context, *entry.first, entry.second)) texts[path] = std::move(*bytes);
  }
  if (context.diagnostics.has_errors()) return {};
  std::vector<std::string> names;
  for (const auto& [path, bytes] : texts) {
    if (write_result(context, path, bytes)) names.push_back(path);
  }
  return names;
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
  const auto loaded = load_robot(context);
  if (!loaded) return finish(context, kExitInvalid);
  const auto verdict = timing_verdict(context, *loaded);
  if (!verdict) return finish(context, kExitInvalid);
  const LintOptions options = lint_options(context, *verdict);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  Diagnostics findings;
  const std::vector<Edit> edits = lint(loaded->robot, options, findings);
  std::vector<std::string> mended;
  if (context.options.fix) mended = write_edits(context, edits);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  return finish_lint(context, findings, mended, edits.size());
}

int finish_lint(Context& context, const Diagnostics& findings, const std::vector<std::string>& mended,
                std::size_t fixable) {
  const bool denied = findings.has_errors() || (context.options.warnings_are_errors && findings.size() > 0);
  if (context.options.format == Format::text && !context.options.quiet) {
    for (const std::string& name : mended) context.out << "fixed " << name << "\n";
    context.out << fmt::format("{} finding{}\n", findings.size(), findings.size() == 1 ? "" : "s");
    if (mended.empty() && fixable > 0) context.out << "run 'finemote lint --fix' to fix the mechanical ones\n";
  }
  return finish_with(context, denied ? kExitNo : kExitYes, findings,
                     Json{{"schema", "finemote.lint/1"}, {"findings", findings.size()}, {"mended", mended}});
}

}  // namespace finemote::gen
