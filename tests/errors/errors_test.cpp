// Every case of this folder: what the tool says of it is exactly what stands in the file beside it.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "cases.hpp"
#include "catch.hpp"
#include "generator/diagnostic/render.hpp"
#include "tests/read.hpp"
#include "tests/rewrites.hpp"

using namespace finemote::gen;
using namespace finemote::test;

namespace {

/// What the tool says of a case, as text; it never makes a robot of it.
std::string say(const Case& test) {
  Said said;
  examine(test, {}, said);
  CHECK(said.diagnostics.has_errors());
  return render_text(said.diagnostics, false);
}

}  // namespace

TEST_CASE("every mistake is explained where it stands") {
  const auto names = case_names();
  REQUIRE(names.size() > 80);
  for (const std::string& name : names) {
    const Case test = find_case(name);
    DYNAMIC_SECTION(name) {
      REQUIRE(std::filesystem::exists(test.input));  // an answer without its robot is run by nobody
      const std::string said = say(test);
      if (name.substr(0, 2) == "FM") CHECK(said.find("error[" + name.substr(0, 6) + "]") != std::string::npos);
      if (finemote::test::rewrites()) std::ofstream(test.expected, std::ios::binary) << said;
      CHECK(said == finemote::test::read(test.expected));
    }
  }
}

TEST_CASE("findings come in file order") {
  for (const std::string& name : case_names()) {
    const Case test = find_case(name);
    std::istringstream said(say(test));
    std::size_t last = 0;
    for (std::string line; std::getline(said, line);) {
      if (line.rfind(test.display + ":", 0) != 0) continue;
      const std::size_t number = std::strtoul(line.c_str() + test.display.size() + 1, nullptr, 10);
      INFO(line);
      CHECK(number >= last);
      last = number;
    }
  }
}
