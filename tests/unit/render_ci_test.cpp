#include "generator/diagnostic/render_ci.hpp"

#include <algorithm>

#include "catch.hpp"
#include "generator/diagnostic/printable.hpp"
#include "generator/diagnostic/render.hpp"

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

TEST_CASE("programs get the place of a file from the working folder on, and the name of what ships") {
  Sources sources;
  Diagnostics diagnostics;
  const SourceFile* own = sources.add({"devices/own.json", "src/./devices/own.json", "{}"});
  const SourceFile* shipped = sources.add({"builtin:devices/led.json", "/usr/share/devices/led.json", "{}"});
  diagnostics.error(Code{3103}, {own, 1, 1, nullptr}, "wrong");
  diagnostics.error(Code{3103}, {shipped, 1, 2, nullptr}, "wrong");
  CHECK(render_gcc(diagnostics) ==
        "builtin:devices/led.json:1:2: error: wrong [FM3103]\nsrc/devices/own.json:1:1: error: wrong [FM3103]\n");
  CHECK(render_github(diagnostics).find("file=src/devices/own.json,line=1,col=1") != std::string::npos);
  const auto log = render_sarif(diagnostics, "0.1.0", "src/in.urdf");
  CHECK(log["runs"][0]["results"][1]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] ==
        "src/devices/own.json");
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

namespace {

/// A macro `wheel` in a.xacro, called on lines 10 and 11 of robot.xacro, and twice by a macro that line 12 calls.
struct Repeated {
  Sources sources;
  Diagnostics diagnostics;
  const SourceFile* robot = sources.add(SourceFile{"robot.xacro", "", ""});
  const SourceFile* macros = sources.add(SourceFile{"a.xacro", "", "<macro>\n  <device name=\"${n}\"/>\n"});

  Position in_macro(std::uint32_t call_line, const Expansion* outer = nullptr) {
    const Position call{robot, call_line, 3, nullptr};
    const Position inner{macros, 7, 1, outer};
    return {macros, 2, 3, sources.add(Expansion{Expansion::Kind::macro, "wheel", outer ? inner : call})};
  }
  void miss_period(const Position& at, const std::string& name) {
    diagnostics.error(Code{3004}, at, "device '" + name + "' has no 'period'").underline(7).hint("add period=\"10ms\"");
  }
  Repeated() {
    miss_period(in_macro(10), "fl");
    const Position second = in_macro(11);
    miss_period(second, "fr");
    diagnostics.error(Code{3004}, second, "device 'other' has no 'period'");
    diagnostics.error(Code{3010}, second, "another code");
    const auto* outer = sources.add(Expansion{Expansion::Kind::macro, "axle", {robot, 12, 3, nullptr}});
    miss_period(in_macro(0, outer), "rl");
    miss_period(in_macro(0, outer), "rr");
    diagnostics.error(Code{3004}, {macros, 2, 3, nullptr}, "device 'x' has no 'period'");
  }
};

}  // namespace

TEST_CASE("repeats of one mistake of a macro are one message with a count and the places") {
  const std::string excerpt = "    2 |   <device name=\"${n}\"/>\n      |   ^";
  CHECK(render_text(Repeated().diagnostics, false) ==
        "a.xacro:2:3: error[FM3004]: device 'x' has no 'period'\n" + excerpt + "\n" +
            "a.xacro:2:3: error[FM3004]: device 'fl' has no 'period'\n" + excerpt + "~~~~~~\n" +
            "  note: expanded from macro 'wheel' at robot.xacro:10:3\n"
            "  note: the same for 3 more expansions, at robot.xacro:11:3, robot.xacro:12:3 (2 times)\n"
            "  hint: add period=\"10ms\"\n"
            "a.xacro:2:3: error[FM3004]: device 'other' has no 'period'\n" +
            excerpt + "\n" +
            "  note: expanded from macro 'wheel' at robot.xacro:11:3\n"
            "a.xacro:2:3: error[FM3010]: another code\n" +
            excerpt + "\n" + "  note: expanded from macro 'wheel' at robot.xacro:11:3\n");
}

TEST_CASE("of very many repeats the first places are named") {
  Repeated many;
  for (std::uint32_t line = 20; line < 40; ++line) many.miss_period(many.in_macro(line), "w");
  const std::string text = render_text(many.diagnostics, false);
  CHECK(text.find("the same for 23 more expansions, at robot.xacro:11:3, robot.xacro:12:3 (2 times), "
                  "robot.xacro:20:3, ") != std::string::npos);
  CHECK(text.find("robot.xacro:29:3 and 10 more places\n") != std::string::npos);
}

TEST_CASE("repeats in the forms for machines stand with the first finding") {
  Repeated findings;
  const auto list = render_json(findings.diagnostics);
  REQUIRE(list.size() == 4);
  CHECK(list[1]["message"] == "device 'fl' has no 'period'");
  CHECK(list[1]["repeats"].size() == 3);
  CHECK(list[1]["repeats"][0].dump() ==
        R"({"message":"device 'fr' has no 'period'","file":"robot.xacro","line":11,"column":3})");
  CHECK_FALSE(list[0].contains("repeats"));
  CHECK(render_gcc(findings.diagnostics) ==
        "a.xacro:2:3: error: device 'x' has no 'period' [FM3004]\n"
        "a.xacro:2:3: error: device 'fl' has no 'period' [FM3004]\n"
        "robot.xacro:11:3: note: the same for 1 more expansion from here\n"
        "robot.xacro:12:3: note: the same for 2 more expansions from here\n"
        "a.xacro:2:3: note: add period=\"10ms\"\n"
        "a.xacro:2:3: error: device 'other' has no 'period' [FM3004]\n"
        "a.xacro:2:3: error: another code [FM3010]\n");
  CHECK(render_github(findings.diagnostics)
            .find("::error file=a.xacro,line=2,col=3,title=FM3004::device 'fl' has no "
                  "'period'%0Anote: the same for 3 more expansions, at ") != std::string::npos);
  const auto log = render_sarif(findings.diagnostics, "0.1.0", "in");
  const auto& result = log["runs"][0]["results"][1];
  CHECK(result["occurrenceCount"] == 4);
  REQUIRE(result["relatedLocations"].size() == 3);
  CHECK(result["relatedLocations"][2]["message"]["text"] == "device 'rr' has no 'period'");
  CHECK(result["relatedLocations"][2]["physicalLocation"]["region"]["startLine"] == 12);
  CHECK_FALSE(log["runs"][0]["results"][0].contains("occurrenceCount"));
}

TEST_CASE("what strangers write cannot command a terminal or a log") {
  CHECK(printable("a\tb \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80") == "a\tb \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80");
  CHECK(printable("k\n::add-mask::x\r\x1b[2J\x7f") == "k?::add-mask::x??[2J?");
  CHECK(printable("\xC2\x9B \xE2\x80\xAE \xE2\x81\xA6") == "?? ??? ???");
  CHECK(printable("\xC3(\xA9 \xE2\x82") == "?(? ??");
}

TEST_CASE("no line of a log is what a stranger wrote from its start") {
  Diagnostics diagnostics;
  diagnostics.error(Code{3021}, {}, "no type 'a\n ::warning::x'").note("b\r\nc").hint("d\n::e");
  for (const std::string& text : {render_text(diagnostics, false), render_gcc(diagnostics)}) {
    CHECK(text.find("'a\n  |  ::warning::x'") != std::string::npos);
    CHECK(text.find("b?\n  | c\n") != std::string::npos);
    CHECK(text.find("d\n  | ::e\n") != std::string::npos);
  }
}
