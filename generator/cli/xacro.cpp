// finemote xacro: the drop-in for ROS xacro.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <iostream>

#include "generator/cli/answer.hpp"
#include "generator/cli/commands.hpp"
#include "generator/diagnostic/clash.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/input/read_document.hpp"
#include "generator/xacro/expand_file.hpp"

namespace finemote::gen {
namespace {

/// What goes to standard output or the output file: the document, or with `--deps` the names of the files.
std::string result_text(const xacro::ExpandedFile& expanded, bool only_dependencies) {
  return only_dependencies ? fmt::format("{}", fmt::join(expanded.dependencies, " ")) : expanded.document;
}

/// Writes the output file, with its folders, as ROS xacro does; a failure (FM1029, or FM5013 for a file that was read)
/// leaves the old file.
void write_output_file(const std::string& path, const std::string& text, Sources& sources, Diagnostics& diagnostics) {
  if (!check_outputs({{path, "-o"}}, sources, diagnostics)) return;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failed;
  if (!folder.empty()) std::filesystem::create_directories(folder, failed);
  auto reason = failed ? std::optional(system_reason(failed.value())) : replace_file(path, text);
  if (!reason) return;
  diagnostics.error(code::xacro_output, {sources.add(SourceFile{path, path, {}})},
                    fmt::format("Failed to open output: {}", *reason));
}

/// Warnings are heard from verbosity 1 on. Nobody asks for warnings as errors and means not to hear of them.
bool hears_warnings(const Options& options) {
  const int verbosity = options.quiet ? 0 : options.verbosity + (options.verbose ? 1 : 0);
  return verbosity > 0 || options.warnings_are_errors;
}

nlohmann::ordered_json document_of(const xacro::ExpandedFile& expanded, const Options& options) {
  nlohmann::ordered_json document{{"schema", "finemote.xacro/1"}, {"dependencies", expanded.dependencies}};
  if (!options.out.empty()) document["output"] = options.out;
  if (options.out.empty() && !options.deps) document["document"] = expanded.document;
  return document;
}

}  // namespace

Answer run_xacro(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const auto folders = package_folders(options.packages, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  if (options.in_order)
    std::cerr << "xacro: in-order processing became default in ROS Melodic. You can drop the option.\n";
  Diagnostics found;
  const auto expanded =
      xacro::expand_file(options.input, xacro_arguments(options.arguments), folders, sources, found, &std::cerr);
  for (const Diagnostic& finding : found.in_file_order()) {
    if (finding.severity == Severity::error || hears_warnings(options)) diagnostics.add(finding);
  }
  if (!expanded || is_refused(options, diagnostics)) return no_answer();
  const std::string text = result_text(*expanded, options.deps);
  if (!options.out.empty()) write_output_file(options.out, text, sources, diagnostics);
  Answer answer{kExitYes, "", document_of(*expanded, options)};
  if (options.out.empty()) answer.file = text;
  return answer;
}

}  // namespace finemote::gen
