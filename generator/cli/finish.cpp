#include "generator/cli/finish.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "generator/cli/exit_status.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/render_ci.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

bool use_color(const Options& options) {
  if (options.color != ColorMode::automatic) return options.color == ColorMode::always;
  const char* no_color = std::getenv("NO_COLOR");
  return (no_color == nullptr || *no_color == '\0') && isatty(STDERR_FILENO) == 1;
}

}  // namespace

std::string render_for_ci(Format format, const Diagnostics& findings, const std::string& input) {
  switch (format) {
    case Format::gcc:
      return render_gcc(findings);
    case Format::github:
      return render_github(findings);
    case Format::sarif:
      return render_sarif(findings, kVersion, input).dump(2) + "\n";
    default:
      return {};
  }
}

void add_findings(const Diagnostics& from, Diagnostics& to) {
  for (const Diagnostic& finding : from.in_file_order()) to.add(finding);
}

void report_unwritten(Context& context, const std::string& path, const std::string& reason) {
  context.diagnostics.error(code::output_not_writable, {}, fmt::format("cannot write '{}': {}", path, reason));
}

bool write_result(Context& context, const std::string& path, std::string_view text) {
  const auto reason = replace_file(path, text);
  if (reason) report_unwritten(context, path, *reason);
  return !reason;
}

bool is_refused(const Context& context) {
  return context.diagnostics.has_errors() || (context.options.warnings_are_errors && context.diagnostics.size() > 0);
}

std::string render_findings(const Context& context) { return render_findings(context, context.diagnostics); }

std::string render_findings(const Context& context, const Diagnostics& findings) {
  return render_text(findings, use_color(context.options));
}

int finish(Context& context, int status, nlohmann::ordered_json document) {
  return finish_with(context, status, {}, std::move(document));
}

int finish_with(Context& context, int status, const Diagnostics& judged, nlohmann::ordered_json document) {
  if (is_refused(context)) status = kExitInvalid;
  Diagnostics all;
  add_findings(context.diagnostics, all);
  add_findings(judged, all);
  context.err << render_findings(context, all);
  const bool answered = status == kExitYes || status == kExitNo;
  if (context.options.format == Format::json && answered && !document.is_null()) {
    document["diagnostics"] = render_json(all);
    context.out << document.dump(2) << "\n";
  }
  // The formats for editors and CI are the result, whatever the status.
  context.out << render_for_ci(context.options.format, all, context.options.input);
  context.out.flush();
  return status;
}

}  // namespace finemote::gen
