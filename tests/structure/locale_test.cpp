// Numbers of users' files mean the same on every machine: nothing in the generator reads them by the locale, or changes
// it.
#include <filesystem>
#include <set>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"
#include "tests/structure/tokens.hpp"

namespace fs = std::filesystem;
using namespace finemote::test;

namespace {

/// Functions to which the locale says what a decimal point is, and what says which locale counts.
const std::set<std::string> kByLocale = {
    "strtod", "strtof",  "strtold", "stod",   "stof",      "stold",     "atof",      "scanf",      "fscanf", "sscanf",
    "vscanf", "vfscanf", "vsscanf", "locale", "setlocale", "newlocale", "uselocale", "localeconv", "imbue"};

}  // namespace

TEST_CASE("nothing in the generator reads numbers by the locale") {
  const fs::path root = finemote::test::source_dir();
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root / "generator")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
    ++files;
    for (const Token& token : tokens_of(read(entry.path()))) {
      if (kByLocale.count(token.text) == 0) continue;
      FAIL_CHECK(entry.path().lexically_relative(root).generic_string()
                 << ":" << token.line << ": '" << token.text << "': read numbers with std::from_chars");
    }
  }
  CHECK(files > 900);
}
