#include "generator/xacro/trail.hpp"

#include <fmt/format.h>

#include "generator/xacro/limits.hpp"

namespace finemote::gen::xacro {

std::string Trail::absolute(const std::string& path) const {
  if (path.starts_with('/')) return path;
  const auto slash = file().rfind('/');
  return slash == std::string::npos ? path : file().substr(0, slash + 1) + path;
}

std::vector<std::string> Trail::lines() const {
  std::vector<std::string> lines;
  const char* before = "when instantiating macro:";
  for (auto macro = macros_.rbegin(); macro != macros_.rend(); ++macro) {
    lines.push_back(fmt::format("{} {} ({})", before, (*macro)->name, (*macro)->file));
    before = "instantiated from:";
  }
  before = macros_.empty() ? "when processing file:" : "in file:";
  for (auto file = files_.rbegin(); file != files_.rend(); ++file) {
    lines.push_back(fmt::format("{} {}", before, *file));
    before = "included from:";
  }
  return lines;
}

void Trail::count(const char* too_many, const Position& at) {
  if (++expansions_ > kMaxCalls) throw Failure{code::xacro_limit, too_many, at};
}

void Trail::check_include(const std::string& file, const Position& at) {
  count("too many included files", at);
  if (files_.size() <= kMaxIncludes) return;
  throw Failure{
      code::xacro_limit,
      fmt::format("'{}' is included inside itself without end, or {} includes are nested", file, kMaxIncludes), at};
}

Trail::Inside<const Macro*> Trail::enter_macro(const Macro& macro, const Position& at) {
  if (++expansions_ > kMaxCalls) {
    throw Failure{code::xacro_limit, fmt::format("more than {} macro calls", kMaxCalls), at};
  }
  if (macros_.size() >= kMaxNestedCalls) {
    throw Failure{code::xacro_limit,
                  fmt::format("maximum recursion depth exceeded: macro '{}' is called inside itself "
                              "without end, or {} calls are nested",
                              macro.name, kMaxNestedCalls),
                  at};
  }
  return {macros_, &macro};
}

Level Trail::enter_block(const char* too_deep, const Position& at) {
  return enter(blocks_, kMaxNestedCalls, too_deep, at);
}

}  // namespace finemote::gen::xacro
