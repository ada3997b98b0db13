#include "generator/xacro/input_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/xacro/source_failure.hpp"

namespace finemote::gen::xacro {

const xml::Document& InputFiles::read_entry(const SourceFile& entry, const std::string& path) {
  auto parsed = xml::read_document(entry);
  if (const auto* broken = std::get_if<xml::Malformed>(&parsed)) throw failure_of(*broken, nullptr);
  auto& document = documents_[path];
  document = std::make_unique<const xml::Document>(std::move(std::get<xml::Document>(parsed)));
  return *document;
}

const xml::Document* InputFiles::include(const std::string& file, bool is_optional, const Position& at) {
  add_dependency(file);
  const SystemError missing = why_unreadable(file, sources_, at);
  if (missing.number == 0) return read_document(file, at);
  if (is_optional) return nullptr;
  sources_.add(SourceFile{file, file, {}});  // for --watch: it may come
  throw Failure{code::xacro_include, fmt::format("{0}: {1} [Errno {2}] {0}: '{1}'", missing.text, file, missing.number),
                at};
}

const SourceFile* InputFiles::open_yaml(const std::string& file, const Position& at) {
  add_dependency(file);
  const SystemError missing = why_unreadable(file, sources_, at);
  if (missing.number != 0) {
    sources_.add(SourceFile{file, file, {}});
    fail(code::xacro_yaml, fmt::format("[Errno {}] {}: '{}'", missing.number, missing.text, file));
  }
  constexpr std::size_t none = 0;
  if (sources_.access().read(file, none) == "") return nullptr;
  return read_text(file, sources_, at);
}

std::vector<std::string> InputFiles::matching(const std::string& path, const std::string& specification,
                                              const Position& at, Warnings& warnings) {
  // The folder that it is relative to is no pattern, whatever it is called.
  if (specification.find_first_of("*[?") == std::string::npos) return {path};
  files::Denial denial;
  auto files = sources_.access().match(path, folders_left_, denial);
  if (denial.is_outside) fail_outside(specification, denial, at);
  if (folders_left_ == 0) throw Failure{code::xacro_limit, "the wild cards go through too many folders", at};
  if (files.empty()) {
    warnings.add(code::xacro_no_match, at, fmt::format("Include tag's filename spec \"{}\" matched no files.", path));
  }
  return files;
}

const xml::Document* InputFiles::read_document(const std::string& file, const Position& at) {
  auto& document = documents_[file];
  if (document) return document.get();
  const Expansion* via = sources_.add(Expansion{Expansion::Kind::include, file, at});
  const SourceFile* source = read_text(file, sources_, at);
  auto parsed = xml::read_document(*source);
  if (const auto* broken = std::get_if<xml::Malformed>(&parsed)) throw failure_of(*broken, via);
  document = std::make_unique<const xml::Document>(std::move(std::get<xml::Document>(parsed)));
  return document.get();
}

void InputFiles::add_dependency(const std::string& file) {
  auto& files = dependencies_.files;
  if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

}  // namespace finemote::gen::xacro
