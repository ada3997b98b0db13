// finemote check: is the output folder what generate would write now?
#include "generator/output/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/dump.hpp"
#include "generator/cli/lint_options.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/shell_word.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/input/read_document.hpp"
#include "generator/run/compiler.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// `generate` or `wcet` with every option that the answer depends on.
std::string command_of(const char* command_name, const std::string& out, const Options& options) {
  std::vector<std::string> words{"finemote", command_name, options.input, "-o", out};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--board", options.board);
  for (const std::string& package : options.packages) add("--package", package);
  for (const std::string& path : options.device_paths) add("--device-path", path);
  add("--data-dir", options.data_dir);
  for (const auto& [name, value] : xacro_arguments(options.arguments)) words.push_back(name + ":=" + value);
  std::string command;
  for (const std::string& word : words) command += (command.empty() ? "" : " ") + shell_word(word);
  return command;
}

/// A command that brings the folder nearer to what it should be.
struct Mend {
  std::string command;
  bool needs_schedulable = false;  ///< it writes nothing for a robot that is not
  bool moves_edited = false;       ///< files that were edited by hand
};

/// What makes the folder what it should be, one after the other.
std::vector<Mend> mends(const Options& options, const CheckResult& result) {
  bool is_written = false, is_edited = false, is_timed = false;
  std::string orphans;
  for (const Finding& finding : result.findings) {
    const bool is_orphan = finding.state == Finding::State::orphan;
    if (finding.state == Finding::State::stale_timing) {
      is_timed = true;
      continue;
    }
    is_written |= !is_orphan;
    is_edited |= finding.state == Finding::State::hand_edited && finding.file != kManifestName;
    if (is_orphan) orphans += " " + shell_word(options.out + "/" + finding.file);
  }
  std::vector<Mend> mends;
  if (is_timed) mends.push_back({command_of("wcet", timing_file_path(options.input), options)});
  if (is_written || is_timed)
    mends.push_back({command_of("generate", options.out, options) + (is_edited ? " --force" : ""), true, is_edited});
  if (!orphans.empty()) mends.push_back({"rm" + orphans});
  return mends;
}

/// The same in words.
std::string way_back(const Options& options, const CheckResult& result, bool schedulable) {
  std::string text;
  for (const Mend& mend : mends(options, result)) {
    const bool must_wait = !schedulable && mend.needs_schedulable;
    text += (must_wait ? "when the robot is schedulable, run: " : "run: ") + mend.command + "\n";
    if (mend.moves_edited) text += "edited files are kept as NAME.orig\n";
  }
  return text;
}

/// One line for each; a reason that several share stands below them, once.
std::string findings_text(const CheckResult& result) {
  const auto follows_change = [](const Finding& finding) { return finding.follows_change; };
  const bool is_shared = std::count_if(result.findings.begin(), result.findings.end(), follows_change) > 1;
  std::string text;
  for (const Finding& finding : result.findings) {
    const std::string reason = is_shared ? finding.reason : result.reason_of(finding);
    text += fmt::format("{:<12} {}{}{}\n", state_name(finding.state), finding.file, reason.empty() ? "" : ": ", reason);
  }
  return is_shared ? text + "because " + result.change + "\n" : text;
}

/// Says that the files are what they should be, and what makes the answer no all the same.
std::string fresh_text(const CheckResult& result, const std::string& objections) {
  std::string text = objections.empty() ? "fresh\n" : "files are fresh, but " + objections + "\n";
  if (result.tool_changed) text += "tool-changed: written by " + result.previous_tool + ", with the same bytes\n";
  if (!result.manifest_change.empty()) {
    text += "manifest-changed: " + result.manifest_change + "; generate would write the manifest, and no other file\n";
  }
  return text;
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

Json document(const Options& options, const CheckResult& result, const std::string& diff) {
  Json findings = Json::array();
  for (const Finding& finding : result.findings) {
    findings.push_back(
        {{"state", state_name(finding.state)}, {"file", finding.file}, {"reason", result.reason_of(finding)}});
  }
  Json commands = Json::array();
  for (const Mend& mend : mends(options, result)) commands.push_back(mend.command);
  Json json{{"schema", "finemote.check/1"},
            {"output", options.out},
            {"fresh", result.findings.empty()},
            {"tool_changed", result.tool_changed},
            {"manifest_change", result.manifest_change.empty() ? Json(nullptr) : Json(result.manifest_change)},
            {"findings", findings},
            {"mend", commands}};
  if (options.diff) json["diff"] = diff;
  return json;
}

/// The answer of what was compared, analysed and linted.
Answer answer_of(const Options& options, const Output& output, const CheckResult& result, const Verdict& verdict,
                 const Diagnostics& lint_findings) {
  const bool denied = is_refused(options, lint_findings);
  const std::string objection = objections(verdict, denied);
  const bool fresh = result.findings.empty();
  const std::string diff = options.diff ? unified_diff(options.out, output, result) : std::string();
  Answer answer{fresh && objection.empty() ? kExitYes : kExitNo};
  answer.text = findings_text(result);
  if (fresh && !options.quiet) answer.text += fresh_text(result, objection);
  answer.text += diff;
  if (!fresh && !options.quiet && options.format == Format::text)
    answer.summary = way_back(options, result, verdict.schedulable);
  answer.judged = verdict.reasons;
  add_findings(lint_findings, answer.judged);
  answer.document = document(options, result, diff);
  answer.document["schedulable"] = verdict.schedulable;
  answer.document["requirements_hold"] = verdict.requirements_hold;
  answer.document["lint"] = render_json(lint_findings);
  return answer;
}

/// Why other files would be generated although neither inputs nor options have changed.
std::string change_beyond_inputs(const TimingFileUse& file) {
  return file.state == TimingFileUse::State::stale
             ? "the timing file is stale: its figures count as assumed"
             : "same inputs and options, but the environment or the build of finemote differs";
}

/// What is wrong with the timing file of the robot; a note where another compiler made the image that it is of.
void add_timing_file(const TimingFileUse& file, CheckResult& result, Diagnostics& diagnostics) {
  if (file.state == TimingFileUse::State::stale) {
    result.findings.push_back(
        {Finding::State::stale_timing, file.path,
         "computed from another state of the robot, its device types, the runtime or the options"});
  }
  if (file.state != TimingFileUse::State::fits) return;
  const std::string here = compiler_for_board();
  if (here == file.compiler && !here.empty()) return;
  diagnostics
      .remark(code::timing_unused, file.at,
              file.compiler.empty()
                  ? std::string("the timing file does not say which compiler made the image of its execution times")
                  : fmt::format("the execution times are of an image made by '{}'", file.compiler))
      .note(here.empty() ? "there is no compiler for the board here"
                         : fmt::format("another compiler is here: '{}'", here));
}

}  // namespace

Answer run_check(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  if (options.out.empty() && !options.dump) {
    diagnostics.error(code::usage, {}, "check needs the folder that holds the generated files").hint("add -o DIR");
    return no_answer();
  }
  const auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  if (options.dump) return dump_robot(options, *input, {}, sources, diagnostics);
  const auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  const Analysis analysis = analyse_robot(*planned, Hints::wanted);
  auto files = emit_files(*planned, prove_bounds(*planned, analysis), input->data_dir, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  const Output output = output_of(std::move(files), *planned, *input, sources);
  CheckResult result = check_output(options.out, output, change_beyond_inputs(planned->timing_file), diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  add_timing_file(planned->timing_file, result, diagnostics);

  const auto verdict = verdict_of(analysis, diagnostics);
  if (!verdict) return no_answer();
  const auto rules = lint_options(options.allow, options.deny, *planned, *analysis.timing, *verdict, diagnostics);
  if (!rules) return no_answer();
  Diagnostics lint_findings;
  lint(planned->robot, *rules, lint_findings);
  Answer answer = answer_of(options, output, result, *verdict, lint_findings);
  if (options.format != Format::text) add_findings(as_diagnostics(options.out, result, sources), answer.judged);
  return answer;
}

}  // namespace finemote::gen
