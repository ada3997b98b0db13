// finemote generate: writes the files of a robot.
#include <fmt/format.h>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/dump.hpp"
#include "generator/cli/robot_input.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/model/firmware_inputs.hpp"
#include "generator/output/write.hpp"
#include "generator/timing_file/user_code.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

/// Escapes a path for a Makefile rule.
std::string make_escaped(const std::string& path) {
  std::string text;
  for (const char c : path) {
    if (c == ' ' || c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
  }
  return text;
}

/// The files on disk that were read.
std::vector<std::string> files_read(const Sources& sources) {
  std::vector<std::string> paths;
  for (const SourceFile& file : sources.files()) {
    if (!file.path.empty() && file.path != "-") paths.push_back(file.path);
  }
  return paths;
}

/// The rule that makes the manifest in `out` depend on every file that was read.
std::string depfile_text(const std::string& out, const Sources& sources) {
  std::string rule = make_escaped(out + "/" + kManifestName) + ":";
  for (const std::string& path : files_read(sources)) rule += " \\\n  " + make_escaped(path);
  return rule + "\n";
}

/// The files that would be written, and in the document what a build needs to know beside them: the board, where the
/// robot's own device types are, and what was read.
Answer list_names(const PlannedRobot& planned, const Sources& sources) {
  std::vector<std::string> names = output_names(planned.robot, planned.forest);
  names.emplace_back(kManifestName);
  Answer answer{kExitYes};
  for (const std::string& name : names) answer.text += name + "\n";
  answer.document = {{"schema", "finemote.list/1"},
                     {"files", names},
                     {"board", planned.robot.board->name},
                     {"code", runs_code_in_sram(planned.robot) ? "sram" : "flash"},
                     {"include_dirs", user_include_dirs(planned.robot)},
                     {"inputs", files_read(sources)}};
  return answer;
}

/// What was done to the folder, or would be.
std::string changes_text(const WriteResult& result, bool dry_run, bool with_written) {
  std::string text;
  if (with_written) {
    for (const std::string& name : result.written) text += (dry_run ? "would write " : "wrote ") + name + "\n";
  }
  for (const auto& [from, to] : result.moved) text += (dry_run ? "would move " : "moved ") + from + " to " + to + "\n";
  for (const std::string& name : result.removed) text += (dry_run ? "would remove " : "removed ") + name + "\n";
  return text;
}

Json moved_list(const WriteResult& result) {
  Json list = Json::array();
  for (const auto& [from, to] : result.moved) list.push_back({{"from", from}, {"to", to}});
  return list;
}

Answer answer_of(const Options& options, const WriteResult& result) {
  Answer answer{kExitYes, changes_text(result, options.dry_run, options.dry_run || options.verbose)};
  if (options.format == Format::text && !options.quiet) {
    answer.summary =
        fmt::format("{}: {} {}, {} unchanged, {} removed\n", options.out, result.written.size(),
                    options.dry_run ? "to write" : "written", result.unchanged.size(), result.removed.size());
  }
  answer.document = {{"schema", "finemote.generate/1"}, {"output", options.out},     {"written", result.written},
                     {"unchanged", result.unchanged},   {"removed", result.removed}, {"moved", moved_list(result)}};
  return answer;
}

Answer refuse_unschedulable(const std::string& out, const Verdict& verdict) {
  Answer answer{kExitNo};
  answer.document = {{"schema", "finemote.generate/1"}, {"output", out}, {"schedulable", false}};
  answer.judged = verdict.reasons;
  answer.closing = "nothing was written; --allow-unschedulable writes anyway\n";
  return answer;
}

/// Whether nothing that was read is overwritten, and nothing is written twice.
bool are_apart(const Options& options, const Output& output, const Robot& robot, Sources& sources,
               Diagnostics& diagnostics) {
  auto planned = planned_files(options.out, output, "-o");
  if (!options.depfile.empty()) planned.push_back({options.depfile, "--depfile"});
  const bool is_fine = check_outputs(planned, sources, diagnostics);
  if (options.depfile.empty() || !is_fine) return is_fine;
  const std::vector<std::string> compiled = user_files(robot, sources.access());
  if (options.dry_run) return check_outputs({{options.depfile, "--depfile"}}, sources, diagnostics, compiled);
  return check_results({{options.depfile, "--depfile"}}, sources, diagnostics, compiled, options.out);
}

/// A requirement that fails refuses nothing here, but nobody should believe that it holds.
void warn_of_requirements(const Verdict& verdict, bool warnings_are_errors, Diagnostics& diagnostics) {
  for (Diagnostic finding : verdict.reasons.in_file_order()) {
    if (finding.code != code::timing_requirement && finding.code != code::timing_above_declared) continue;
    finding.severity = Severity::warning;
    finding.note(warnings_are_errors
                     ? "without -W error generate would write the files; analyze and check exit with status 1"
                     : "generate still writes the files; analyze and check exit with status 1");
    diagnostics.add(finding);
  }
}

/// Writes the files of a robot that may be written.
Answer write_files(const Options& options, const Output& output, const Robot& robot, Sources& sources,
                   Diagnostics& diagnostics) {
  if (!are_apart(options, output, robot, sources, diagnostics)) return no_answer();
  const WriteResult result = write_output(
      options.out, output, {options.dry_run, options.force, options.warnings_are_errors}, sources, diagnostics);
  if (is_refused(options, diagnostics)) return no_answer();
  if (!options.depfile.empty() && !options.dry_run)
    write_result(options.depfile, depfile_text(options.out, sources), diagnostics);
  return answer_of(options, result);
}

}  // namespace

Answer run_generate(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  if (options.out.empty() && !options.list && !options.dump) {
    diagnostics.error(code::usage, {}, "generate needs a folder to write to").hint("add -o DIR");
    return no_answer();
  }
  const auto input = input_of(options, diagnostics);
  if (!input) return no_answer();
  if (options.dump) return dump_robot(options, *input, {}, sources, diagnostics);
  const auto planned = plan_robot(*input, sources, diagnostics);
  if (!planned) return no_answer();
  if (options.list) return list_names(*planned, sources);

  const Analysis analysis = analyse_robot(*planned, options.allow_unschedulable ? Hints::left_out : Hints::wanted);
  if (!options.allow_unschedulable) {
    const auto verdict = verdict_of(analysis, diagnostics);
    if (!verdict) return no_answer();
    for (const Diagnostic& overload : verdict->overloads) diagnostics.add(overload);
    if (!verdict->schedulable) return refuse_unschedulable(options.out, *verdict);
    warn_of_requirements(*verdict, options.warnings_are_errors, diagnostics);
  }
  auto files = emit_files(*planned, prove_bounds(*planned, analysis), input->data_dir, diagnostics);
  if (is_refused(options, diagnostics)) return no_answer();
  return write_files(options, output_of(std::move(files), *planned, *input, sources), planned->robot, sources,
                     diagnostics);
}

}  // namespace finemote::gen
