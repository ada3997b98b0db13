#include "generator/xacro/command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>

#include "generator/diagnostic/clash.hpp"
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

PackagePath packages_of(const XacroOptions& options) {
  PackagePath packages = options.access.is_sandbox() ? PackagePath() : PackagePath::from_environment();
  for (const auto& [name, folder] : options.packages) packages.add(name, folder);
  if (options.input != "-") packages.set_entry(options.input);
  return packages;
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

std::optional<Expanded> expand_input(const XacroOptions& options, Sources& sources, Diagnostics& diagnostics,
                                     std::ostream& err) {
  if (options.in_order) err << "xacro: in-order processing became default in ROS Melodic. You can drop the option.\n";
  Dependencies dependencies;
  const SourceFile* entry = xml::read_source(options.input, sources, diagnostics);
  if (entry == nullptr) return std::nullopt;
  const auto document =
      expand(*entry, options.arguments, packages_of(options), sources, diagnostics, dependencies, &err);
  if (!document) return std::nullopt;
  return Expanded{xml::write(*document, options.input), std::move(dependencies.files)};
}

std::string result_text(const Expanded& expansion, const XacroOptions& options) {
  return options.only_dependencies ? fmt::format("{}", fmt::join(expansion.dependencies, " ")) : expansion.document;
}

void write_output_file(const std::string& path, const std::string& text, Diagnostics& diagnostics, Sources& sources) {
  if (!check_outputs({{path, "-o"}}, sources, diagnostics)) return;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failed;
  if (!folder.empty()) std::filesystem::create_directories(folder, failed);
  auto reason = failed ? std::optional(system_reason(failed.value())) : replace_file(path, text);
  if (!reason) return;
  diagnostics.error(code::xacro_output, {sources.add(SourceFile{path, path, {}})},
                    fmt::format("Failed to open output: {}", *reason));
}

Diagnostics heard(const Diagnostics& all, const XacroOptions& options) {
  Diagnostics findings;
  for (const Diagnostic& finding : all.in_file_order()) {
    if (finding.severity == Severity::error || options.verbosity > 0) findings.add(finding);
  }
  return findings;
}

int run_xacro(const XacroOptions& options, std::ostream& out, std::ostream& err) {
  constexpr int done = 0;
  constexpr int failed = 2;
  Sources sources(options.access);
  Diagnostics diagnostics;
  const auto expansion = expand_input(options, sources, diagnostics, err);
  if (expansion && !options.output.empty())
    write_output_file(options.output, result_text(*expansion, options), diagnostics, sources);
  err << render_text(heard(diagnostics, options), options.color);
  if (diagnostics.has_errors()) return failed;
  if (options.output.empty()) out << result_text(*expansion, options) << std::flush;
  return done;
}

}  // namespace finemote::gen::xacro
