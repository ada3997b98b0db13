#include "generator/file/wild_card.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <string>

namespace finemote::gen::files {
namespace {

/// Length of what stands for one letter at the start of a pattern that does not begin with `*`.
std::size_t unit_length(std::string_view pattern) {
  if (pattern[0] == '\\') return std::min<std::size_t>(2, pattern.size());
  if (pattern[0] != '[') return 1;
  const std::size_t negation = pattern.size() > 1 && (pattern[1] == '!' || pattern[1] == '^') ? 1 : 0;
  std::size_t at = 1 + negation;
  if (pattern.substr(at).starts_with(']')) ++at;  // a first ']' is one of the letters
  while (at < pattern.size() && pattern[at] != ']') {
    const auto end = pattern.substr(at).starts_with("[:") ? pattern.find(":]", at + 2) : std::string_view::npos;
    at = end == std::string_view::npos ? at + 1 : end + 2;  // a class such as [:digit:]
  }
  return at < pattern.size() ? at + 1 : 1;
}

bool unit_matches(std::string_view unit, char letter) {
  if (unit == "?") return true;
  if (unit.size() == 1) return unit[0] == letter && letter != '\\';
  const char name[] = {letter, '\0'};
  return ::fnmatch(std::string(unit).c_str(), name, 0) == 0;
}

}  // namespace

bool is_wild(std::string_view component) { return component.find_first_of("*?[") != std::string_view::npos; }

bool matches(std::string_view pattern, std::string_view name) {
  if (name.starts_with('.') && !pattern.starts_with('.') && !pattern.starts_with("\\.")) return false;
  // The last `*` takes as little as it can: what the ones before it took need not be tried again.
  std::string_view after_star = pattern;
  std::string_view taken_from = name;
  bool has_star = false;
  while (!name.empty() || !pattern.empty()) {
    if (pattern.starts_with('*')) {
      pattern.remove_prefix(1);
      after_star = pattern, taken_from = name, has_star = true;
      continue;
    }
    const std::size_t unit = pattern.empty() ? 0 : unit_length(pattern);
    if (unit > 0 && !name.empty() && unit_matches(pattern.substr(0, unit), name[0])) {
      pattern.remove_prefix(unit), name.remove_prefix(1);
      continue;
    }
    if (!has_star || taken_from.empty()) return false;
    taken_from.remove_prefix(1);
    name = taken_from, pattern = after_star;
  }
  return true;
}

}  // namespace finemote::gen::files
