// The xacro module alone, for running cases against it without the rest of the tool.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <string_view>

#include "generator/diagnostic/render.hpp"
#include "generator/xacro/expand_file.hpp"

using namespace finemote::gen;

int main(int count, char** words) {
  std::string input;
  xacro::Arguments arguments;
  bool only_dependencies = false;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (xacro::add_argument(word, arguments)) continue;
    if (word == "--deps")
      only_dependencies = true;
    else
      input = word;
  }
  Sources sources;
  Diagnostics diagnostics;
  const auto expanded = xacro::expand_file(input, arguments, {}, sources, diagnostics, &std::cerr);
  std::cerr << render_text(diagnostics, false);
  if (!expanded) return 2;
  std::cout << (only_dependencies ? fmt::format("{}", fmt::join(expanded->dependencies, " ")) : expanded->document);
}
