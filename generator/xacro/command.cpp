#include "generator/xacro/command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>

#include "generator/diagnostic/render.hpp"
#include "generator/file/replace_file.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/xml/read_source.hpp"
#include "generator/xml/write.hpp"

namespace finemote::gen::xacro {
namespace {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f\v";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Diagnostics errors_of(const Diagnostics& all) {
  Diagnostics errors;
  for (const Diagnostic& finding : all.in_file_order()) {
    if (finding.severity != Severity::error) continue;
    Diagnostic& copy = errors.error(finding.code, finding.at, finding.message);
    copy = finding;
  }
  return errors;
}

void print(const Diagnostics& diagnostics, const XacroOptions& options, std::ostream& err) {
  err << render_text(options.verbosity > 0 ? diagnostics : errors_of(diagnostics), options.color);
}

PackagePath packages_of(const XacroOptions& options) {
  PackagePath packages = options.access.is_sandbox() ? PackagePath() : PackagePath::from_environment();
  for (const auto& [name, folder] : options.packages) packages.add(name, folder);
  if (options.input != "-") packages.set_entry(options.input);
  return packages;
}

/// Makes the folders around the file, as ROS xacro does; a failure leaves the old file.
void write_file(const std::string& path, const std::string& text, Diagnostics& diagnostics, Sources& sources) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failed;
  if (!folder.empty()) std::filesystem::create_directories(folder, failed);
  auto reason = failed ? std::optional(system_reason(failed.value())) : replace_file(path, text);
  if (!reason) return;
  diagnostics.error(code::xacro_output, {sources.add(SourceFile{path, path, {}})},
                    fmt::format("Failed to open output: {}", *reason));
}

}  // namespace

bool add_argument(std::string_view word, Arguments& arguments) {
  const auto mark = word.find(":=");
  if (mark == std::string_view::npos) return false;
  const std::string_view name = without_blanks(word.substr(0, mark));
  const std::string_view value = without_blanks(word.substr(mark + 2));
  const bool is_private = name.size() > 1 && name[0] == '_' && name[1] != '_';
  if (!name.empty() && !value.empty() && !is_private) arguments[std::string(name)] = value;
  return true;
}

int run_xacro(const XacroOptions& options, std::ostream& out, std::ostream& err) {
  constexpr int done = 0;
  constexpr int failed = 2;
  if (options.in_order) err << "xacro: in-order processing became default in ROS Melodic. You can drop the option.\n";
  Sources sources(options.access);
  Diagnostics diagnostics;
  Dependencies dependencies;
  const SourceFile* entry = xml::read_source(options.input, sources, diagnostics);
  std::optional<xml::Document> document;
  if (entry != nullptr) {
    document = expand(*entry, options.arguments, packages_of(options), sources, diagnostics, dependencies, &err);
  }
  std::string text;
  if (document) {
    text = options.only_dependencies ? fmt::format("{}", fmt::join(dependencies.files, " "))
                                     : xml::write(*document, options.input);
    if (!options.output.empty()) write_file(options.output, text, diagnostics, sources);
  }
  print(diagnostics, options, err);
  if (diagnostics.has_errors()) return failed;
  if (options.output.empty()) out << text << std::flush;
  return done;
}

}  // namespace finemote::gen::xacro
