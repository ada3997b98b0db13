#include "generator/input/read_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/xacro/expand_file.hpp"
#include "generator/xml/parse.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

bool refuse_model(const Input& input, Diagnostics& diagnostics) {
  if (!is_timing_model(input.path)) return false;
  diagnostics.error(code::usage, {}, fmt::format("'{}' is a timing model; this command needs a robot", input.path))
      .hint("analyze, simulate and diff take models");
  return true;
}

}  // namespace

/// To forget silently what means something to xacro alone would be worse than an error.
bool refuse_arguments(const std::string& path, const std::vector<std::pair<std::string, std::string>>& arguments,
                      Diagnostics& diagnostics) {
  if (is_xacro(path) || arguments.empty()) return false;
  const auto& [name, value] = arguments.front();
  Diagnostic& finding = diagnostics.error(
      code::usage, {}, fmt::format("'{}:={}' is for xacro, and '{}' is not read as xacro", name, value, path));
  if (!is_timing_model(path)) finding.hint("give the file the suffix .xacro");
  return true;
}

std::vector<std::pair<std::string, std::string>> package_folders(const std::vector<std::string>& words,
                                                                 Diagnostics& diagnostics) {
  std::vector<std::pair<std::string, std::string>> folders;
  for (const std::string& word : words) {
    const auto package = package_of(word);
    if (!package) {
      diagnostics.error(code::usage, {}, fmt::format("--package '{}' has no name and folder", word))
          .hint("write --package name=dir");
      continue;
    }
    std::error_code failed;
    const fs::path folder = fs::absolute(package->second, failed);  // as written, it would follow the file
    folders.emplace_back(package->first, failed ? package->second : folder.lexically_normal().string());
  }
  return folders;
}

xacro::Arguments xacro_arguments(const std::vector<std::pair<std::string, std::string>>& words) {
  xacro::Arguments arguments;
  for (const auto& [name, value] : words) xacro::add_argument(name + ":=" + value, arguments);
  return arguments;
}

std::optional<xml::Document> read_document(const Input& input, Sources& sources, Diagnostics& diagnostics) {
  if (refuse_arguments(input.path, input.arguments, diagnostics) || refuse_model(input, diagnostics))
    return std::nullopt;
  const SourceFile* file = input.text != nullptr ? sources.add({input.path, input.path, *input.text})
                                                 : xml::read_source(input.path, sources, diagnostics);
  if (file == nullptr) return std::nullopt;
  if (!is_xacro(input.path)) return xml::parse(*file, diagnostics);
  const auto folders = package_folders(input.packages, diagnostics);
  xacro::Dependencies dependencies;
  return xacro::expand(*file, xacro_arguments(input.arguments),
                       xacro::package_path(input.path, folders, sources.access()), sources, diagnostics, dependencies,
                       input.messages);
}

std::vector<std::string> argument_words(const Input& input) {
  std::vector<std::string> words;
  for (const auto& [name, value] : xacro_arguments(input.arguments)) words.push_back(name + ":=" + value);
  std::sort(words.begin(), words.end());
  return words;
}

}  // namespace finemote::gen
