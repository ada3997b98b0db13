// finemote generate: writes the files of a robot.
#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/cli/exit_status.hpp"
#include "generator/cli/finish.hpp"
#include "generator/cli/load.hpp"
#include "generator/cli/verdict.hpp"
#include "generator/output/write.hpp"

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

void write_depfile(Context& context, const std::string& out) {
  std::string rule = make_escaped(out + "/" + kManifestName) + ":";
  for (const SourceFile& file : context.sources.files()) {
    if (!file.path.empty() && file.path != "-") rule += " \\\n  " + make_escaped(file.path);
  }
  write_result(context, context.options.depfile, rule + "\n");
}

int list_names(Context& context, const Loaded& loaded) {
  std::vector<std::string> names = output_names(loaded.robot, loaded.forest);
  names.emplace_back(kManifestName);
  if (context.options.format == Format::text) {
    for (const std::string& name : names) context.out << name << "\n";
  }
  return finish(context, kExitYes, Json{{"schema", "finemote.list/1"}, {"files", names}});
}

void print_summary(Context& context, const WriteResult& result) {
  if (context.options.format != Format::text) return;
  const char* verb = context.options.dry_run ? "would write" : "wrote";
  for (const std::string& name : result.written) {
    if (context.options.dry_run || context.options.verbose) context.out << verb << " " << name << "\n";
  }
  for (const auto& [from, to] : result.moved)
    context.out << (context.options.dry_run ? "would move " : "moved ") << from << " to " << to << "\n";
  for (const std::string& name : result.removed) {
    context.out << (context.options.dry_run ? "would remove " : "removed ") << name << "\n";
  }
  if (context.options.quiet) return;
  context.err << fmt::format("{}: {} {}, {} unchanged, {} removed\n", context.options.out, result.written.size(),
                             context.options.dry_run ? "to write" : "written", result.unchanged.size(),
                             result.removed.size());
}

int refuse_unschedulable(Context& context, const Verdict& verdict) {
  const int status =
      finish_with(context, kExitNo, verdict.reasons,
                  Json{{"schema", "finemote.generate/1"}, {"output", context.options.out}, {"schedulable", false}});
  context.err << "nothing was written; --allow-unschedulable writes anyway\n";
  return status;
}

Json moved_list(const WriteResult& result) {
  Json list = Json::array();
  for (const auto& [from, to] : result.moved) list.push_back({{"from", from}, {"to", to}});
  return list;
}

/// Whether nothing that was read is overwritten, and nothing is written twice.
bool are_apart(Context& context, const Output& output) {
  auto planned = planned_files(context.options.out, output, "-o");
  if (!context.options.depfile.empty()) planned.push_back({context.options.depfile, "--depfile"});
  return check_outputs(planned, context.sources, context.diagnostics);
}

/// A requirement that fails refuses nothing here, but nobody should believe that it holds.
void warn_of_requirements(Context& context, const Verdict& verdict) {
  for (Diagnostic finding : verdict.reasons.in_file_order()) {
    if (finding.code != code::timing_requirement) continue;
    finding.severity = Severity::warning;
    finding.note(context.options.warnings_are_errors
                     ? "without -W error generate would write the files; analyze and check exit with status 1"
                     : "generate still writes the files; analyze and check exit with status 1");
    context.diagnostics.add(finding);
  }
}

}  // namespace

int run_generate(Context& context) {
  const Options& options = context.options;
  if (options.out.empty() && !options.list) {
    context.diagnostics.error(code::usage, {}, "generate needs a folder to write to").hint("add -o DIR");
    return finish(context, kExitInvalid);
  }
  const auto loaded = load_robot(context);
  if (!loaded) return finish(context, kExitInvalid);
  if (options.list) return list_names(context, *loaded);

  if (!options.allow_unschedulable) {
    const auto verdict = timing_verdict(context, *loaded, CommandAges::left_out);
    if (!verdict) return finish(context, kExitInvalid);
    for (const Diagnostic& overload : verdict->overloads) context.diagnostics.add(overload);
    if (!verdict->schedulable) return refuse_unschedulable(context, *verdict);
    warn_of_requirements(context, *verdict);
  }
  auto files = render_robot(context, *loaded);
  if (is_refused(context)) return finish(context, kExitInvalid);
  const Output output =
      make_output(std::move(files), input_files(context, *loaded), loaded->robot.name.text, output_options(options));
  if (!are_apart(context, output)) return finish(context, kExitInvalid);
  const WriteResult result =
      write_output(options.out, output, {options.dry_run, options.force, options.warnings_are_errors}, context.sources,
                   context.diagnostics);
  if (is_refused(context)) return finish(context, kExitInvalid);
  if (!options.depfile.empty() && !options.dry_run) write_depfile(context, options.out);
  print_summary(context, result);
  return finish(context, kExitYes,
                Json{{"schema", "finemote.generate/1"},
                     {"output", options.out},
                     {"written", result.written},
                     {"unchanged", result.unchanged},
                     {"removed", result.removed},
                     {"moved", moved_list(result)}});
}

}  // namespace finemote::gen
