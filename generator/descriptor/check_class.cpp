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
  if (std::find(kGenerated.begin(), kGenerated.end(), include) == kGenerated.end()) return;
  found.add({"header"}, fmt::format("a generated file is called '{}' too", include))
      .hint("give the header another name, for example that of its class");
}

}  // namespace finemote::gen
