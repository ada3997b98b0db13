#include "generator/diagnostic/render_ci.hpp"

#include <algorithm>

#include "catch.hpp"

using namespace finemote::gen;

namespace {

struct Findings {
  Sources sources;
  Diagnostics diagnostics;
  const SourceFile* file = sources.add(SourceFile{"my robot.urdf", "", "<robot>\n  <bus port=\"i2c9\"/>\n"});

  Findings() {
    diagnostics.error(Code{3012}, {file, 2, 14, nullptr}, "no port 'i2c9', 100%")
        .underline(4)
        .note("a note", {file, 1, 1, nullptr})
        .hint("a hint");
    diagnostics.warning(Code{3153}, {}, "nowhere");
  }
};

}  // namespace

TEST_CASE("gcc: place, severity, message, code, then notes") {
  Findings findings;
  CHECK(render_gcc(findings.diagnostics) ==
        "finemote: warning: nowhere [FM3153]\n"
        "my robot.urdf:2:14: error: no port 'i2c9', 100% [FM3012]\n"
        "my robot.urdf:1:1: note: a note\n"
        "my robot.urdf:2:14: note: a hint\n");
}

TEST_CASE("github: one escaped line each, at most ten of a kind") {
  Findings findings;
  CHECK(
      render_github(findings.diagnostics) ==
      "::warning title=FM3153::nowhere\n"
      "::error file=my robot.urdf,line=2,col=14,title=FM3012::no port 'i2c9', 100%25%0Anote: a note%0Ahint: a hint\n");
  Diagnostics many;
  for (int i = 0; i < 12; ++i) many.error(Code{1}, {}, "again");
  const std::string text = render_github(many);
  CHECK(std::count(text.begin(), text.end(), '\n') == 10);
  CHECK(text.find("::error title=FineMote::and 3 more\n") != std::string::npos);
}

TEST_CASE("sarif: every result has a rule and a relative location") {
  Findings findings;
  const auto log = render_sarif(findings.diagnostics, "0.1.0", "in.urdf");
  CHECK(log["version"] == "2.1.0");
  const auto& run = log["runs"][0];
  CHECK(run["tool"]["driver"]["rules"].size() == 2);
  REQUIRE(run["results"].size() == 2);
  const auto& without_place = run["results"][0]["locations"][0]["physicalLocation"];
  CHECK(without_place["artifactLocation"]["uri"] == "in.urdf");
  CHECK(without_place["region"]["startLine"] == 1);
  const auto& placed = run["results"][1]["locations"][0]["physicalLocation"];
  CHECK(placed["artifactLocation"]["uri"] == "my%20robot.urdf");
  CHECK(placed["region"] == nlohmann::ordered_json{{"startLine", 2}, {"startColumn", 14}, {"endColumn", 18}});
  CHECK(run["results"][1]["message"]["text"] == "no port 'i2c9', 100%\nnote: a note\nhint: a hint");
}
