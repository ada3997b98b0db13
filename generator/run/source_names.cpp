#include "generator/run/source_names.hpp"

#include <filesystem>
#include <string_view>

namespace finemote::gen {
namespace {

namespace fs = std::filesystem;

/// The longest end of a path that is a file below `folder`; empty: none is.
std::string end_below(const fs::path& folder, const fs::path& path) {
  std::error_code ignored;
  for (auto first = path.begin(); first != path.end(); ++first) {
    fs::path end;
    for (auto part = first; part != path.end(); ++part) end /= *part;
    if (end.is_relative() && *end.begin() != ".." && fs::is_regular_file(folder / end, ignored))
      return end.generic_string();
  }
  return {};
}

}  // namespace

SourceNames::SourceNames(const std::string& data_dir, const std::string& robot_folder)
    : roots_{{data_dir, "finemote/"}, {robot_folder, ""}} {}

std::string SourceNames::known_name(const std::string& file) const {
  // Where a project is made of generated files alone, the compiler is told to call its folder `robot`.
  constexpr std::string_view kGenerated = "robot/generated/";
  const fs::path path = fs::path(file).lexically_normal();
  const std::string text = path.generic_string();
  const std::size_t at = text.find(kGenerated);
  if (at != std::string::npos) return text.substr(at + std::string_view("robot/").size());
  for (const auto& [folder, begin] : roots_) {
    const std::string end = end_below(folder, path);
    if (!end.empty()) return begin + end;
  }
  return {};
}

std::string SourceNames::of(const std::string& file) const {
  const std::string known = known_name(file);
  return known.empty() ? fs::path(file).filename().generic_string() : known;
}

bool SourceNames::is_of_library(const std::string& file) const {
  if (!known_name(file).empty()) return false;
  std::error_code ignored;
  return file.find("/c++/") != std::string::npos || !fs::exists(file, ignored);
}

}  // namespace finemote::gen
