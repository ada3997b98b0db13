#include "generator/input/input.hpp"

#include <filesystem>

namespace finemote::gen {

namespace fs = std::filesystem;

bool is_xacro(const std::string& path) { return fs::path(path).extension() == ".xacro"; }

std::string input_name(const std::string& path) { return path == "-" ? "stdin" : fs::path(path).filename().string(); }

std::string input_folder(const std::string& path) {
  if (path == "-") return fs::current_path().string();
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

}  // namespace finemote::gen
