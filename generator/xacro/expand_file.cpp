#include "generator/xacro/expand_file.hpp"

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

PackagePath package_path(const std::string& entry, const PackageFolders& folders, const files::Access& access) {
  PackagePath packages = access.is_sandbox() ? PackagePath() : PackagePath::from_environment();
  for (const auto& [name, folder] : folders) packages.add(name, folder);
  if (entry != "-") packages.set_entry(entry);
  return packages;
}

std::optional<ExpandedFile> expand_file(const std::string& path, const Arguments& arguments,
                                        const PackageFolders& folders, Sources& sources, Diagnostics& diagnostics,
                                        std::ostream* messages) {
  Dependencies dependencies;
  const SourceFile* entry = xml::read_source(path, sources, diagnostics);
  if (entry == nullptr) return std::nullopt;
  const PackagePath packages = package_path(path, folders, sources.access());
  const auto document = expand(*entry, arguments, packages, sources, diagnostics, dependencies, messages);
  if (!document) return std::nullopt;
  return ExpandedFile{xml::write(*document, path), std::move(dependencies.files)};
}

}  // namespace finemote::gen::xacro
