// The catalogue is complete: every number has a page that explains it, and every mistake of a robot's file an example.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "generator/diagnostic/catalogue.hpp"
#include "generator/diagnostic/render.hpp"

using namespace finemote::gen;
namespace fs = std::filesystem;

namespace {

const std::string kSource = FINEMOTE_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Name -> number of every constant in code.hpp.
std::map<std::string, int> declared_codes() {
  const std::string text = read(fs::path(kSource) / "generator/diagnostic/code.hpp");
  const std::regex declaration(R"(inline constexpr Code (\w+)\{(\d+)\})");
  std::map<std::string, int> codes;
  for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match) {
    codes[(*match)[1]] = std::stoi((*match)[2]);
  }
  return codes;
}

/// Numbers some case of this folder is named after; errors_test checks that the case produces it.
std::set<int> example_codes() {
  std::set<int> codes;
  for (const auto& entry : fs::directory_iterator(fs::path(kSource) / "tests/errors")) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("FM", 0) == 0 && name.size() > 6) codes.insert(std::stoi(name.substr(2, 4)));
  }
  return codes;
}

bool is_mistake_of_a_robot(int number) { return number == 1001 || number == 1002 || (number > 2000 && number < 3150); }

}  // namespace

TEST_CASE("every number is used for one mistake") {
  std::set<int> seen;
  for (const auto& [name, number] : declared_codes()) {
    INFO(name);
    CHECK(seen.insert(number).second);
  }
  CHECK(seen.size() > 100);
}

TEST_CASE("every number has a page with title and explanation, and every page a number") {
  std::set<int> declared;
  for (const auto& [name, number] : declared_codes()) {
    declared.insert(number);
    const Code code{static_cast<std::uint16_t>(number)};
    INFO(name << " " << code_name(code));
    const auto page = explain(kSource, code);
    REQUIRE(page);
    CHECK(page->rfind("# " + code_name(code) + ": ", 0) == 0);
    const std::string body = page->substr(page->find('\n'));
    CHECK(body.find_first_not_of('\n') != std::string::npos);
    CHECK((body.find("Wrong:") == std::string::npos) == (body.find("Right:") == std::string::npos));
  }
  for (const CatalogueEntry& entry : list_catalogue(kSource)) {
    INFO(code_name(entry.code) << " " << entry.title);
    CHECK(declared.count(entry.code.number) == 1);
    CHECK_FALSE(entry.title.empty());
  }
}

TEST_CASE("every mistake of a robot's file has an example") {
  const std::set<int> examples = example_codes();
  for (const auto& [name, number] : declared_codes()) {
    if (!is_mistake_of_a_robot(number)) continue;
    INFO(name << " " << number);
    CHECK(examples.count(number) == 1);
  }
}

TEST_CASE("a code is found however it is written") {
  CHECK(parse_code("FM3012") == Code{3012});
  CHECK(parse_code("fm0001") == Code{1});
  CHECK(parse_code("3012") == Code{3012});
  CHECK_FALSE(parse_code("FM"));
  CHECK_FALSE(parse_code("FM30x2"));
  CHECK_FALSE(parse_code("FM030120"));
  CHECK_FALSE(parse_code(""));
  CHECK_FALSE(explain(kSource, Code{2999}));
}
