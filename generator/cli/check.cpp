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

void print_findings(Context& context, const CheckResult& result) {
  for (const Finding& finding : result.findings) {
    context.out << fmt::format("{:<12} {}: {}\n", state_name(finding.state), finding.file, finding.reason);
  }
  if (result.findings.empty() && !context.options.quiet) {
    context.out << "fresh\n";
    if (result.tool_changed)
      context.out << "tool-changed: written by " << result.previous_tool << ", with the same bytes\n";
  }
  if (!result.findings.empty() && !context.options.quiet) {
    context.err << fmt::format("run: finemote generate {} -o {}\n", context.options.input, context.options.out);
  }
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
  const Output output = make_output(std::move(files), input_files(context, *loaded), loaded->robot.name.text);
  const CheckResult result = check_output(context.options.out, output, context.diagnostics);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);

  const std::string diff = context.options.diff ? unified_diff(context.options.out, output, result) : std::string();
  if (context.options.format == Format::text) {
    print_findings(context, result);
    context.out << diff;
  }
  const auto verdict = timing_verdict(context, *loaded);
  if (!verdict) return finish(context, kExitInvalid);
  Diagnostics lint_findings;
  lint(loaded->robot, lint_options(context, *verdict), lint_findings);
  if (context.diagnostics.has_errors()) return finish(context, kExitInvalid);
  Diagnostics judged = verdict->reasons;
  add_findings(lint_findings, judged);

  const bool denied = lint_findings.has_errors() || (context.options.warnings_are_errors && lint_findings.size() > 0);
  const bool good = result.findings.empty() && verdict->schedulable && verdict->requirements_hold && !denied;
  Json json = document(context, result, diff);
  json["schedulable"] = verdict->schedulable;
  json["requirements_hold"] = verdict->requirements_hold;
  json["lint"] = render_json(lint_findings);
  return finish_with(context, good ? kExitYes : kExitNo, judged, std::move(json));
}

}  // namespace finemote::gen
