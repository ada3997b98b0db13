#include "generator/input/input.hpp"

#include <filesystem>

namespace finemote::gen {

namespace fs = std::filesystem;

bool is_xacro(const std::string& path) { return fs::path(path).extension() == ".xacro"; }

bool is_timing_model(const std::string& path) { return fs::path(path).extension() == ".json"; }

std::optional<std::pair<std::string, std::string>> package_of(const std::string& word) {
  const auto equals = word.find('=');
  if (equals == std::string::npos || equals == 0) return std::nullopt;
  return std::pair(word.substr(0, equals), word.substr(equals + 1));
}

std::string input_name(const std::string& path) { return path == "-" ? "stdin" : fs::path(path).filename().string(); }

std::string input_folder(const std::string& path) {
  if (path == "-") return fs::current_path().string();
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

}  // namespace finemote::gen
