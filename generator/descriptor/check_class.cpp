#include "generator/descriptor/check_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "generator/descriptor/cpp_words.hpp"

namespace finemote::gen {
namespace {

/// In the folder of generated files, which the compiler searches first; generator/emit/render.cpp fills them.
constexpr std::array<std::string_view, 3> kGenerated{"buses.hpp", "constants.hpp", "schedule.hpp"};

/// Headers of the C library, which code of others includes by these names.
constexpr std::array<std::string_view, 29> kLibrary{
    "assert.h",  "complex.h", "ctype.h",  "errno.h",  "fenv.h",   "float.h",       "inttypes.h", "iso646.h",
    "limits.h",  "locale.h",  "math.h",   "setjmp.h", "signal.h", "stdalign.h",    "stdarg.h",   "stdatomic.h",
    "stdbool.h", "stddef.h",  "stdint.h", "stdio.h",  "stdlib.h", "stdnoreturn.h", "string.h",   "tgmath.h",
    "threads.h", "time.h",    "uchar.h",  "wchar.h",  "wctype.h"};

bool is_in(const auto& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void check_class(const std::string& qualified, const Contradictions& found) {
  for (std::size_t begin = 0; begin < qualified.size();) {
    const std::size_t end = std::min(qualified.find("::", begin), qualified.size());
    const std::string name = qualified.substr(begin, end - begin);
    if (const auto fault = invalid_name(name)) {
      found.add({"class"}, fmt::format("'{}' {}, so no class can have it in its name", name, *fault));
      return;
    }
    begin = end + 2;
  }
}

void check_include(const std::string& include, const Contradictions& found) {
  const bool is_generated = is_in(kGenerated, include);
  if (!is_generated && !is_in(kLibrary, include)) return;
  found
      .add({"header"},
           fmt::format("a {} is called '{}' too", is_generated ? "generated file" : "header of the C library", include))
      .hint("give the header another name, for example that of its class");
}

}  // namespace finemote::gen
