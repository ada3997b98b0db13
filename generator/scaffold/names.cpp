#include "generator/scaffold/names.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace finemote::gen {
namespace {

// No locale decides what a letter is.
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return is_lower(c) || (c >= 'A' && c <= 'Z'); }

constexpr std::string_view kTaken[] = {"all",     "bin",           "clean", "debug", "edit_cache", "finemote",
                                       "flash",   "generate",      "hex",   "help",  "host",       "install",
                                       "package", "rebuild_cache", "rtt",   "size",  "test"};

}  // namespace

std::string project_name(const std::string& folder) {
  std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();
  std::string name = path.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_letter(c) && !is_digit(c); }, '_');
  if (name.empty() || name.front() == '_' || is_digit(name.front())) name = "robot" + name;
  if (std::find(std::begin(kTaken), std::end(kTaken), name) != std::end(kTaken)) name += "_robot";
  return name;
}

bool is_type_name(const std::string& name) {
  const auto fits = [](char c) { return is_lower(c) || is_digit(c) || c == '_'; };
  return !name.empty() && is_lower(name.front()) && std::all_of(name.begin(), name.end(), fits);
}

std::string camel_case(const std::string& type) {
  std::string name;
  bool is_begin = true;
  for (const char c : type) {
    if (c == '_') {
      is_begin = true;
      continue;
    }
    name += is_begin && is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c;
    is_begin = false;
  }
  return name;
}

}  // namespace finemote::gen
