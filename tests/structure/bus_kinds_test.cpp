// What is particular to a kind of bus stands in generator/bus: other folders ask its record and name no kind.
#include <filesystem>
#include <regex>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/read.hpp"

namespace fs = std::filesystem;
using finemote::test::read;

namespace {

int count_kinds(const std::string& text) {
  const std::regex kind(R"(\bBusKind::\w)");
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), kind), std::sregex_iterator()));
}

}  // namespace

TEST_CASE("kinds of bus are named in generator/bus only") {
  const fs::path generator = fs::path(finemote::test::source_dir()) / "generator";
  for (const auto& entry : fs::recursive_directory_iterator(generator)) {
    const fs::path extension = entry.path().extension();
    const std::string file = entry.path().lexically_relative(generator).generic_string();
    if ((extension != ".cpp" && extension != ".hpp") || file.rfind("bus/", 0) == 0) continue;
    const int found = count_kinds(read(entry.path()));
    if (found > 0)
      FAIL_CHECK("generator/" << file << " names kinds of bus " << found
                              << " times: ask bus_type(kind), and add what is missing to the records in generator/bus");
  }
}
