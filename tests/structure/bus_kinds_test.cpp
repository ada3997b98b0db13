// What is particular to a kind of bus stands in generator/bus: other folders ask its record and name no kind.
#include <filesystem>
#include <regex>

#include "catch.hpp"
#include "tests/read.hpp"

namespace fs = std::filesystem;
using finemote::test::read;

namespace {

/// A file that names a kind on purpose, how often, and why its record cannot say it.
struct Exception {
  std::string_view file;
  int times;
  std::string_view reason;
};

constexpr Exception kExceptions[] = {
    {"model/expanders.cpp", 4, "expanders sit on i2c, and their named channels are i2c"},
    {"descriptor/read_expander_type.cpp", 2, "what an expander provides: i2c as a mux, pwm as an object"},
};

int count_kinds(const std::string& text) {
  const std::regex kind(R"(\bBusKind::\w)");
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), kind), std::sregex_iterator()));
}

int allowed_in(const std::string& file) {
  for (const Exception& entry : kExceptions) {
    if (entry.file == file) return entry.times;
  }
  return 0;
}

}  // namespace

TEST_CASE("kinds of bus are named in generator/bus, and where a rule is truly about one of them") {
  const fs::path generator = fs::path(FINEMOTE_SOURCE_DIR) / "generator";
  for (const auto& entry : fs::recursive_directory_iterator(generator)) {
    const fs::path extension = entry.path().extension();
    const std::string file = entry.path().lexically_relative(generator).generic_string();
    if ((extension != ".cpp" && extension != ".hpp") || file.rfind("bus/", 0) == 0) continue;
    const int found = count_kinds(read(entry.path())), allowed = allowed_in(file);
    if (found > allowed)
      FAIL_CHECK("generator/" << file << " names kinds of bus " << found
                              << " times: ask bus_type(kind), and add what is missing to the records in generator/bus");
    if (found < allowed)
      FAIL_CHECK("generator/" << file << " names kinds of bus " << found << " times: lower its exception");
  }
}
