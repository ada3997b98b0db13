// Every `@param NAME` of a header stands above a declaration that has a parameter of that name.
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

/// What a parameter can be: the names before a `,`, a `)`, a default value or the size of an array.
std::set<std::string> parameters_of(const std::string& declaration) {
  static const std::set<std::string> kBehind = {",", ")", "=", "["};
  const std::vector<Token> tokens = tokens_of(declaration);
  std::set<std::string> names;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (kBehind.count(tokens[i + 1].text) == 1) names.insert(tokens[i].text);
  }
  return names;
}

/// The names of a line `/// @param NAME, NAME  text`; none of any other line.
std::vector<std::string> documented_in(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  if (!(words >> word) || word != "///" || !(words >> word) || word != "@param") return {};
  std::vector<std::string> names;
  for (word = ","; word.back() == ',' && words >> word;) names.push_back(word.substr(0, word.find(',')));
  return names;
}

/// `line 12: NAME` for every one that is no parameter of the declaration that ends there.
std::vector<std::string> unknown_parameters(const std::string& header) {
  std::istringstream lines(header);
  std::vector<std::string> documented, unknown;
  std::string declaration;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    for (std::string& name : documented_in(line)) documented.push_back(std::move(name));
    if (documented.empty() || line.find("///") != std::string::npos) continue;
    declaration += line + '\n';
    const auto open = std::count(declaration.begin(), declaration.end(), '(');
    if (open == 0 || open != std::count(declaration.begin(), declaration.end(), ')')) continue;
    const std::set<std::string> parameters = parameters_of(declaration);
    for (const std::string& name : documented) {
      if (parameters.count(name) == 0) unknown.push_back("line " + std::to_string(number) + ": " + name);
    }
    documented.clear(), declaration.clear();
  }
  return unknown;
}

}  // namespace

TEST_CASE("parameters are found in declarations of several lines") {
  CHECK(unknown_parameters("/// @param a, b  one\n/// @param c  two\nint f(int a, int b[2],\n      S c = {});\n")
            .empty());
  CHECK(unknown_parameters("/// @param a  one\nA f(int c);\n") == std::vector<std::string>{"line 2: a"});
}

TEST_CASE("comments describe parameters that the declaration has") {
  const fs::path root = finemote::test::source_dir();
  for (const char* folder : {"generator", "runtime", "emulator"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".hpp") continue;
      for (const std::string& unknown : unknown_parameters(read(entry.path())))
        FAIL_CHECK(entry.path().lexically_relative(root).generic_string() << ", " << unknown << " is no parameter");
    }
  }
}
