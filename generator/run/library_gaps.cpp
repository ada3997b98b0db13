#include "generator/run/library_gaps.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>

#include "generator/run/code_line.hpp"

namespace finemote::gen {
namespace {

/// What stands in for some functions.
std::string_view instead_of(std::string_view function) {
  constexpr struct {
    std::string_view function, instead;
  } kKnown[] = {
      {"sin", "use finemote::sine() of finemote/control/sine.hpp"},
      {"sinf", "use finemote::sine() of finemote/control/sine.hpp"},
      {"cos", "use finemote::cosine() of finemote/control/sine.hpp"},
      {"cosf", "use finemote::cosine() of finemote/control/sine.hpp"},
      {"memset", "give it a size that the compiler knows, or write the loop"},
      {"memcmp", "write the loop"},
      {"strlen", "keep the length with the text"},
  };
  for (const auto& known : kKnown) {
    if (known.function == function) return known.instead;
  }
  return "do without it";
}

/// Of C, or in the namespace of the library of C++.
bool has_library_name(const std::string& function) {
  const std::string_view name = std::string_view(function).substr(0, function.find_first_of("<("));
  const bool is_of_c = name.size() == function.size() && name.find(':') == std::string_view::npos;
  return is_of_c || name.find("std::") != std::string_view::npos;
}

bool is_of_library(const wcet::TimeGap& gap, const SourceLines& lines, const SourceNames& names) {
  if (!has_library_name(gap.function)) return false;
  const auto line = code_line(lines, gap.address);
  return line && names.is_of_library(line->file);
}

}  // namespace

std::vector<wcet::TimeGap> blame_callers_of_libraries(const std::vector<wcet::TimeGap>& gaps, const SourceLines& lines,
                                                      const SourceNames& names) {
  std::vector<wcet::TimeGap> blamed;
  std::set<std::uint32_t> calls;
  for (wcet::TimeGap gap : gaps) {
    std::string called;
    while (!gap.calls.empty() && is_of_library(gap, lines, names)) {
      called = gap.function;
      move_to_caller(gap);
    }
    if (!called.empty()) {
      if (!calls.insert(gap.address).second) continue;
      gap.why = fmt::format("'{}' is a function of the library, and has no bound: {}", called, instead_of(called));
    }
    blamed.push_back(std::move(gap));
  }
  return blamed;
}

}  // namespace finemote::gen
