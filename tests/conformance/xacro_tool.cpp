// The xacro command alone, for running cases against the module without the rest of the tool.
#include <iostream>
#include <string_view>

#include "generator/xacro/command.hpp"

int main(int count, char** words) {
  finemote::gen::xacro::XacroOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (finemote::gen::xacro::add_argument(word, options.arguments)) continue;
    if (word == "-o" && i + 1 < count) {
      options.output = words[++i];
    } else if (word == "--deps") {
      options.only_dependencies = true;
    } else if (word == "-q") {
      options.verbosity = 0;
    } else {
      options.input = word;
    }
  }
  return finemote::gen::xacro::run_xacro(options, std::cout, std::cerr);
}
