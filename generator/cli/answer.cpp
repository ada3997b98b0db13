#include "generator/cli/answer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/render_ci.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/version.hpp"

namespace finemote::gen {
namespace {

bool use_color(ColorMode color) {
  if (color != ColorMode::automatic) return color == ColorMode::always;
  const char* no_color = std::getenv("NO_COLOR");
  return (no_color == nullptr || *no_color == '\0') && isatty(STDERR_FILENO) == 1;
}

/// What --format json prints.
std::string json_text(Answer& answer, const Diagnostics& findings) {
  if (answer.document.is_null()) return answer.text;
  answer.document["diagnostics"] = render_json(findings);
  return document_text(answer.document);
}

}  // namespace

std::string document_text(const nlohmann::ordered_json& document) {
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string render_for_ci(Format format, const Diagnostics& findings, const std::string& input) {
  switch (format) {
    case Format::gcc:
      return render_gcc(findings);
    case Format::github:
      return render_github(findings);
    case Format::sarif:
      return document_text(render_sarif(findings, kVersion, input));
    default:
      return {};
  }
}

void add_findings(const Diagnostics& from, Diagnostics& to) {
  for (const Diagnostic& finding : from.in_file_order()) to.add(finding);
}

void report_unwritten(const std::string& path, const std::string& reason, Diagnostics& diagnostics) {
  diagnostics.error(code::output_not_writable, {}, fmt::format("cannot write '{}': {}", path, reason));
}

bool write_result(const std::string& path, std::string_view text, Diagnostics& diagnostics) {
  const auto reason = replace_file(path, text);
  if (reason) report_unwritten(path, *reason, diagnostics);
  return !reason;
}

bool denies_warnings(const Options& options, const Diagnostics& findings) {
  return options.warnings_are_errors && findings.has_errors_or_warnings();
}

bool is_refused(const Options& options, const Diagnostics& findings) {
  return findings.has_errors() || denies_warnings(options, findings);
}

int finish(const Options& options, Answer answer, const Diagnostics& diagnostics, std::ostream& out,
           std::ostream& err) {
  const bool is_denied = answer.status == kExitYes && denies_warnings(options, diagnostics);
  int status = diagnostics.has_errors() || is_denied ? kExitInvalid : answer.status;
  Diagnostics findings;
  add_findings(diagnostics, findings);
  add_findings(answer.judged, findings);
  const bool answered = status == kExitYes || status == kExitNo;
  const bool is_json_wanted = options.format == Format::json || !options.json.empty();
  const std::string json = answered && is_json_wanted ? json_text(answer, findings) : "";
  if (answered && !options.json.empty() && !write_result(options.json, json, findings)) status = kExitInvalid;
  if (options.format == Format::text || options.format == Format::markdown) out << answer.text;
  err << answer.summary << render_text(findings, use_color(options.color));
  if (options.format == Format::text) out << answer.file;
  if (options.format == Format::json && status != kExitInvalid) out << json;
  // The formats for editors and CI are the result, whatever the status.
  out << render_for_ci(options.format, findings, options.input);
  out.flush();
  err << answer.closing;
  return status;
}

}  // namespace finemote::gen
