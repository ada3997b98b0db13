// finemote check: is the output folder what generate would write now?
#include "generator/output/check.hpp"

#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/lint_options.hpp"
#include "generator/cli/load.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/diagnostic/render.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// A word of a command line as a shell takes it.
std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./:=,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// `generate` with every option that the answer depends on.
std::string generate_command(const Options& options) {
  std::vector<std::string> words{"finemote", "generate", options.input, "-o", options.out};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--board", options.board);
  for (const std::string& package : options.packages) add("--package", package);
  for (const std::string& path : options.device_paths) add("--device-path", path);
  add("--data-dir", options.data_dir);
  for (const auto& [name, value] : xacro_arguments(options)) words.push_back(name + ":=" + value);
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + shell_word(word);
  return command;
}

/// The command that makes the files what they should be.
std::string way_back(const Context& context, const CheckResult& result, bool schedulable) {
  bool is_written = false, is_edited = false;
  for (const Finding& finding : result.findings) {
    is_written |= finding.state != Finding::State::orphan;
    is_edited |= finding.state == Finding::State::hand_edited && finding.file != kManifestName;
  }
  if (!is_written) return "remove the files that are orphans\n";
  const std::string run = (schedulable ? "run: " : "when the robot is schedulable, run: ");
  const std::string command = run + generate_command(context.options);
  return command + (is_edited ? " --force\nedited files are kept as NAME.orig\n" : "\n");
}

void print_findings(Context& context, const CheckResult& result, bool schedulable) {
  for (const Finding& finding : result.findings) {
    context.out << fmt::format("{:<12} {}: {}\n", state_name(finding.state), finding.file, finding.reason);
  }
  if (!result.findings.empty() && !context.options.quiet) context.err << way_back(context, result, schedulable);
}

/// Says that the files are what they should be, and what makes the answer no all the same.
void print_fresh(Context& context, const CheckResult& result, const std::string& objections) {
  if (!result.findings.empty() || context.options.quiet) return;
  context.out << (objections.empty() ? "fresh\n" : "files are fresh, but " + objections + "\n");
  if (result.tool_changed)
    context.out << "tool-changed: written by " << result.previous_tool << ", with the same bytes\n";
  if (!result.manifest_change.empty())
    context.out << "manifest-changed: " << result.manifest_change
                << "; generate would write the manifest, and no other file\n";
}

std::string objections(const Verdict& verdict, bool denied) {
  std::string text;
  const auto add = [&](bool holds, const char* words) {
    if (!holds) text += (text.empty() ? "" : ", ") + std::string(words);
  };
  add(verdict.schedulable, "the robot is not schedulable");
  add(verdict.requirements_hold, "a requirement does not hold");
  add(!denied, "lint has findings that are denied");
  return text;
}

Json document(const Context& context, const CheckResult& result, const std::string& diff) {
  Json findings = Json::array();
  for (const Finding& finding : result.findings) {
    findings.push_back({{"state", state_name(finding.state)}, {"file", finding.file}, {"reason", finding.reason}});
  }
  Json json{{"schema", "finemote.check/1"},
            {"output", context.options.out},
            {"fresh", result.findings.empty()},
            {"tool_changed", result.tool_changed},
            {"manifest_change", result.manifest_change.empty() ? Json(nullptr) : Json(result.manifest_change)},
            {"findings", findings}};
  if (context.options.diff) json["diff"] = diff;
  return json;
}

}  // namespace

int run_check(Context& context) {
  const auto loaded = load_robot(context);
  if (!loaded) return finish(context, kExitInvalid);
  auto files = render_robot(context, *loaded);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  const Output output = make_output(std::move(files), input_files(context, *loaded), loaded->robot.name.text,
                                    output_options(context.options));
  const CheckResult result = check_output(context.options.out, output, context.diagnostics);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);

  const auto verdict = timing_verdict(context, *loaded, CommandAges::needed);
  if (!verdict) return finish(context, kExitInvalid);
  Diagnostics lint_findings;
  lint(loaded->robot, lint_options(context, *verdict), lint_findings);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  Diagnostics judged = verdict->reasons;
  add_findings(lint_findings, judged);

  const bool denied = lint_findings.has_errors() || (context.options.warnings_are_errors && lint_findings.size() > 0);
  const std::string objection = objections(*verdict, denied);
  const bool good = result.findings.empty() && objection.empty();
  const std::string diff = context.options.diff ? unified_diff(context.options.out, output, result) : std::string();
  if (context.options.format == Format::text) {
    print_findings(context, result, verdict->schedulable);
    print_fresh(context, result, objection);
    context.out << diff;
  } else {
    add_findings(as_diagnostics(context.options.out, result, context.sources), judged);
  }
  Json json = document(context, result, diff);
  json["schedulable"] = verdict->schedulable;
  json["requirements_hold"] = verdict->requirements_hold;
  json["lint"] = render_json(lint_findings);
  return finish_with(context, good ? kExitYes : kExitNo, judged, std::move(json));
}

}  // namespace finemote::gen
