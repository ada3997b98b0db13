#include "generator/timing_file/user_code.hpp"

#include <filesystem>
#include <string_view>
#include <utility>

#include "generator/model/firmware_inputs.hpp"
#include "generator/timing_file/directives.hpp"
#include "generator/timing_file/logical_lines.hpp"
#include "generator/xml/read_source.hpp"

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// Sources in a folder, in the order of names; not those below.
std::vector<SourceText> sources_in(const std::string& folder, const files::Access& access) {
  files::Denial denial;
  std::vector<SourceText> files;
  for (const std::string& entry : access.list(folder, denial)) {
    if (!has_source_name(entry)) continue;
    const std::string path = (fs::path(folder) / entry).string();
    if (access.why_not(path)) continue;
    if (auto text = access.read(path, xml::kMaxFileSize)) files.push_back({entry, path, std::move(*text)});
  }
  return files;
}

void append(std::vector<SourceText>& all, std::vector<SourceText> more) {
  for (SourceText& file : more) all.push_back(std::move(file));
}

/// All that the compiler may read of the folders of a robot's own device types.
std::vector<SourceText> user_texts(const Robot& robot, const files::Access& access) {
  const std::vector<std::string> folders = user_include_dirs(robot);
  std::vector<SourceText> all;
  for (const std::string& folder : folders) append(all, sources_in(folder, access));
  append(all, included_files(all, {}, folders, access));
  return all;
}

/// `new` in any spelling, or what the library has for it. There is no heap, so it is in a given place.
bool makes_in_place(std::string_view lines) {
  for (const std::string_view word : {"construct", "uninitialized_"}) {
    if (lines.find(word) != std::string_view::npos) return true;
  }
  constexpr std::string_view kNew = "new";
  for (std::size_t at = lines.find(kNew); at != std::string_view::npos; at = lines.find(kNew, at + 1)) {
    const std::size_t end = at + kNew.size();
    if ((at == 0 || !is_of_word(lines[at - 1])) && (end == lines.size() || !is_of_word(lines[end]))) return true;
  }
  return false;
}

}  // namespace

std::vector<SourceText> user_code(const std::vector<OutputFile>& generated, const std::vector<SourceText>& shipped,
                                  const std::vector<std::string>& folders, const files::Access& access) {
  if (folders.empty()) return {};
  std::vector<SourceText> compiled;
  for (const std::string& folder : folders) {
    for (SourceText& file : sources_in(folder, access)) {
      if (fs::path(file.name).extension() == ".cpp") compiled.push_back(std::move(file));
    }
  }
  std::vector<SourceText> including = compiled;
  for (const OutputFile& file : generated) including.push_back({file.name, "", file.text});
  append(compiled, included_files(including, shipped, folders, access));
  return compiled;
}

std::vector<std::string> user_files(const Robot& robot, const files::Access& access) {
  const std::vector<SourceText> all = user_texts(robot, access);
  std::vector<std::string> paths;
  paths.reserve(all.size());
  for (const SourceText& file : all) paths.push_back(file.path);
  return paths;
}

UserWords user_words(const Robot& robot, const files::Access& access) {
  UserWords words;
  const auto says_mutable = [](std::string_view text) { return text.find("mutable") != std::string_view::npos; };
  for (const SourceText& file : user_texts(robot, access)) {
    const std::string lines = logical_lines(file.text);
    const bool is_pasted = has_pasted_words(lines);
    // Raw strings are taken for others: what follows one may be taken for a comment.
    const bool has_raw_string = file.text.find("R\"") != std::string::npos;
    words.has_mutable |= is_pasted || says_mutable(file.text) || says_mutable(lines);
    words.makes_in_place |= is_pasted || makes_in_place(lines) || (has_raw_string && makes_in_place(file.text));
  }
  return words;
}

}  // namespace finemote::gen
