// <base>.timing.json: written by wcet, taken by every command that analyses, and told from one that is out of date.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "cli/program.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

constexpr const char* kDescriptor = R"({"schema": "finemote.device/1", "type": "counter", "summary": "counts",
  "class": "Counter", "header": "counter.hpp", "provides": [], "params": [],
  "wcet": {"update_ns": 20000, "handle_ns": 1000}})";

/// A robot with one device of the user, whose update() iterates a number of times, and with <wcet> or not.
class OneRobot {
 public:
  OneRobot() {
    write_file(folder_.path("devices/counter.json"), kDescriptor);
    turn(5);
    describe("");
    REQUIRE(run_finemote({"wcet", robot(), "-o", timing_file()}).exit_status == 0);
  }

  void turn(int rounds) const {
    write_file(folder_.path("devices/counter.hpp"),
               "#pragma once\n#include <cstdint>\nclass Counter {\n public:\n  constexpr Counter() = default;\n"
               "  void update() { for (int i = 0; i < " +
                   std::to_string(rounds) +
                   "; ++i) sum_ = sum_ + i; }\n  void handle() {}\n private:\n  int volatile sum_ = 0;\n};\n");
  }

  void describe(const std::string& children, const std::string& period = "5ms") const {
    write_file(robot(), R"(<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>
  <device name="own" type="counter" period=")" +
                            period + "\">" + children + "</device></finemote></robot>");
  }

  [[nodiscard]] std::string robot() const { return folder_.path("r.urdf"); }
  [[nodiscard]] std::string timing_file() const { return folder_.path("r.timing.json"); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

  void edit(const std::string& text, const std::string& by) const {
    std::string all = read_file(timing_file());
    const std::size_t at = all.find(text);
    REQUIRE(at != std::string::npos);
    write_file(timing_file(), all.replace(at, text.size(), by));
  }

 private:
  TemporaryFolder folder_;
};

/// What one command says of the device.
struct Told {
  int status;
  Json document;
  std::string output;

  [[nodiscard]] bool says(const std::string& text) const { return output.find(text) != std::string::npos; }
  [[nodiscard]] const Json& label() const { return document["wcet_labels"][0]; }
  [[nodiscard]] std::int64_t update_ns() const { return document["model"]["devices"][0]["update_wcet_ns"]; }
};

Told told_by(std::vector<std::string> words) {
  words.insert(words.end(), {"--format", "json"});
  const auto result = run_finemote(words);
  const auto begin = result.output.find("{\n  \"schema\""),
             end = result.output.rfind("\n}");  // messages may stand around it
  Json document = begin == std::string::npos || end == std::string::npos
                      ? Json()
                      : Json::parse(result.output.substr(begin, end + 2 - begin), nullptr, false);
  return {result.exit_status, std::move(document), result.output};
}

std::int64_t bound_of(const OneRobot& one, const std::string& stage) {
  const Json document = Json::parse(read_file(one.timing_file()));
  for (const Json& entry : document["stages"]) {
    if (entry["stage"] == stage) return entry["wcet_ns"];
  }
  return -1;
}

}  // namespace

TEST_CASE("bounds beside a robot are its execution times, called static") {
  const OneRobot one;
  const Told told = told_by({"analyze", one.robot(), "--require-static"});
  CAPTURE(told.output);
  CHECK(told.status == 0);
  CHECK(told.label()["label"] == "static");
  CHECK(told.update_ns() == bound_of(one, "update"));
  CHECK(told.update_ns() < 20000);
  CHECK_FALSE(told.says("FM4020"));
  const Told run = told_by({"run", one.robot(), "--duration", "50ms"});
  CHECK(run.status == 0);
  CHECK(run.document["stages"][0]["wcet_label"] == "static");
  CHECK(run.document["stages"][0]["wcet_ns"] == bound_of(one, "update"));
}

TEST_CASE("a sandbox sees the same file and the same inputs") {
  const OneRobot one;
  CHECK(told_by({"analyze", one.robot(), "--require-static", "--sandbox"}).status == 0);
  one.turn(9);
  CHECK(told_by({"analyze", one.robot(), "--sandbox"}).says("FM4022"));
}

TEST_CASE("without its file a robot has no static time, and --require-static says so") {
  const OneRobot one;
  write_file(one.path("other.urdf"), read_file(one.robot()));
  const Told told = told_by({"analyze", one.path("other.urdf"), "--require-static"});
  CHECK(told.status == 1);
  CHECK(told.says("the execution times of 'own' are assumed, not static"));
}

TEST_CASE("wcet writes the same bytes before and after generate, wherever the robot lies") {
  const OneRobot one;
  const std::string before = read_file(one.timing_file());
  REQUIRE(run_finemote({"generate", one.robot(), "-o", one.path("out")}).exit_status == 0);
  REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
  CHECK(read_file(one.timing_file()) == before);
  const Json manifest = Json::parse(read_file(one.path("out/finemote.manifest.json")));
  CHECK(manifest.dump().find("r.timing.json") != std::string::npos);
  write_file(one.path("renamed.urdf"), read_file(one.robot()));
  write_file(one.path("renamed.timing.json"), before);
  CHECK(told_by({"analyze", one.path("renamed.urdf"), "--require-static"}).status == 0);
}

TEST_CASE("a loop made longer makes the file stale: check says so, and its figures are assumed") {
  const OneRobot one;
  REQUIRE(run_finemote({"generate", one.robot(), "-o", one.path("out")}).exit_status == 0);
  CHECK(told_by({"check", one.robot(), "-o", one.path("out")}).status == 0);
  one.turn(9);
  const Told check = told_by({"check", one.robot(), "-o", one.path("out")});
  CHECK(check.status == 1);
  bool is_stale = false;
  for (const Json& finding : check.document["findings"]) is_stale |= finding["state"] == "stale-timing";
  CHECK(is_stale);
  CHECK(check.document["mend"][0].get<std::string>().rfind("finemote wcet ", 0) == 0);
  for (const Json& finding : check.document["findings"]) {
    if (finding["state"] == "stale")
      CHECK(finding["reason"] == "the timing file is stale: its figures count as assumed");
  }
  const Told told = told_by({"analyze", one.robot()});
  CHECK(told.status == 0);
  CHECK(told.says("FM4022"));
  CHECK(told.label()["label"] == "assumed");
  CHECK(told.update_ns() == bound_of(one, "update"));
  CHECK(told_by({"analyze", one.robot(), "--require-static"}).status == 1);
}

TEST_CASE("a file that a source includes from elsewhere, through another one, makes it stale") {
  const OneRobot one;
  const std::string source = read_file(one.path("devices/counter.hpp"));
  write_file(one.path("devices/counter.hpp"), "#include \"../common/rates.hpp\"\n" + source);
  write_file(one.path("common/rates.hpp"), "  #  include <../common/rates.inc> // what they are\n");
  write_file(one.path("common/rates.inc"), "// one\n");
  REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
  CHECK(told_by({"analyze", one.robot(), "--require-static"}).status == 0);

  write_file(one.path("common/rates.inc"), "// two\n");
  CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
  write_file(one.path("common/rates.inc"), "#include \"rates.hpp\"\n");  // a ring of files
  CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
}

TEST_CASE("a file is an input of a timing file however its name stands in the directive") {
  const OneRobot one;
  const std::string source = read_file(one.path("devices/counter.hpp"));
  for (const char* directive :
       {"#include /* which */ \"body.inc\"",
        "/* a comment\n over lines */ #include \"body.inc\"",
        "%:include \"body.inc\"",
        "#inc\\\nlude \"body.inc\"",
        "#if defined(NO) || __has_include(\"body.inc\")\n#endif",
        "inline const char* words = R\"x(say \"a/*\")x\";\n#include \"body.inc\"",
        "#define TEXT(x) #x\n#define TABLE(name) TEXT(name.inc)\n#include TABLE(body)",
        "#define TEXT(x) #x\n#define TABLE(name) TEXT(../devices/name.inc)\n#include TABLE(body)",
        "// nothing\r#include \"body.inc\"",
        "#define TEXT(x) #x\n#if __has_include(TEXT(body.inc))\n#endif",
        "#define PASTE(a, b) a##b\n#define ASK(x) PASTE(__has_, include)(x)\n#if ASK(\"body.inc\")\n#endif",
        "inline const char* words = \".incbin\";",
        "#define TEXT_OF(x) #x\n#define TEXT(x) TEXT_OF(x)\n"
        "#define TABLE TEXT(body.inc)\n#include TABLE",
        "#define TABLE\"body.inc\"\n#include TABLE",
        "#define IS_THERE(x) __has_include(x)\n#if IS_THERE(\"body.inc\")\n#endif",
        "#ifdef __has_include\n#define OWN __has_include\n#if OWN(\"body.inc\")\n#endif\n#endif",
        "inline constexpr int many = 10'000 + '\"' - 0x1'0;\n#include \"body.inc\"",
        "#include \\ \n\"body.inc\"",
        "#include\f\"body.inc\"",
        "inline void none() { asm(\".if 0\\n.inc\" \"bin \\\"body.inc\\\"\\n.endif\"); }"}) {
    CAPTURE(directive);
    write_file(one.path("devices/counter.hpp"), std::string(directive) + "\n" + source);
    write_file(one.path("devices/body.inc"), "// one\n");
    REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
    write_file(one.path("devices/body.inc"), "// two\n");
    CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
  }
}

TEST_CASE("a file that stands in for a header of finemote makes a timing file stale") {
  const OneRobot one;
  write_file(one.path("devices/finemote/schedule.hpp"), "#include_next <finemote/schedule.hpp>\n");
  CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
}

TEST_CASE("a file that comes to stand in another's place makes a timing file stale") {
  const char* const kPlaces[] = {
      "devices/string.h",         // which <cstring> includes
      "devices/sys/cdefs.h",      // and that one
      "devices/body.hpp.gch",     // in place of body.hpp
      "devices/body.hpp.gch/x",   // the same
      "devices/right/rates.inc",  // beside the second name of a file
  };
  for (const std::string place : kPlaces) {
    CAPTURE(place);
    const OneRobot one;
    const std::string source = read_file(one.path("devices/counter.hpp"));
    write_file(one.path("devices/counter.hpp"),
               "#include <cstring>\n#include \"body.hpp\"\n#include \"left/asks.hpp\"\n#include \"right/asks.hpp\"\n" +
                   source);
    write_file(one.path("devices/body.hpp"), "// nothing\n");
    write_file(one.path("common/asks.hpp"), "#if __has_include(\"rates.inc\")\n#endif\n");
    for (const char* side : {"left", "right"}) {
      std::filesystem::create_directories(one.path(std::string("devices/") + side));
      std::filesystem::create_symlink("../../common/asks.hpp", one.path(std::string("devices/") + side + "/asks.hpp"));
    }
    REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
    CHECK(told_by({"analyze", one.robot(), "--require-static"}).status == 0);
    write_file(one.path(place), "// there\n");
    CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
  }
}

TEST_CASE("what an assembler reads is an input of a timing file byte by byte") {
  const OneRobot one;
  const std::string source = read_file(one.path("devices/counter.hpp"));
  write_file(one.path("devices/counter.hpp"),
             source + "inline void none() { asm(\".if 0\\n.incbin \\\"body.bin\\\"\\n.endif\"); }\n");
  write_file(one.path("devices/body.bin"), "1\r\n2");
  REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
  CHECK_FALSE(told_by({"analyze", one.robot()}).says("FM4022"));
  write_file(one.path("devices/body.bin"), "1\n2");
  CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
}

TEST_CASE("a name that a macro of another folder gives is looked for beside the line that includes it") {
  const OneRobot one;
  const std::string source = read_file(one.path("devices/counter.hpp"));
  write_file(one.path("devices/counter.hpp"), "#include \"../common/names.hpp\"\n#include TABLE\n" + source);
  write_file(one.path("common/names.hpp"), "#define TABLE \"table.inc\"\n");
  write_file(one.path("devices/table.inc"), "// one\n");
  REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
  write_file(one.path("devices/table.inc"), "// two\n");
  CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
}

TEST_CASE("files are inputs of a timing file by what includes them, not by their names and places") {
  const OneRobot one;
  const std::string source = read_file(one.path("devices/counter.hpp"));
  write_file(one.path("devices/counter.hpp"),
             "#include \"Rounds\"\n#define TABLE \"sub/.hidden/table.txt\"\n#include TABLE\n" + source);
  write_file(one.path("devices/Rounds"), "// one\n");
  write_file(one.path("devices/sub/.hidden/table.txt"), "// one\n");
  write_file(one.path("devices/unused.hpp"), "// one\n");
  REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
  const auto is_stale = [&] { return told_by({"analyze", one.robot()}).says("FM4022"); };

  write_file(one.path("devices/unused.hpp"), "// two\n");
  write_file(one.path("devices/Rounds"), "// one\r\n");
  CHECK_FALSE(is_stale());
  write_file(one.path("devices/Rounds"), "// two\n");
  CHECK(is_stale());
  write_file(one.path("devices/Rounds"), "// one\n");
  CHECK_FALSE(is_stale());
  write_file(one.path("devices/sub/.hidden/table.txt"), "// two\n");
  CHECK(is_stale());
}

TEST_CASE("what is made of a robot is no input of its timing file, wherever a macro may include from") {
  const OneRobot one;
  const std::string source = read_file(one.path("devices/counter.hpp"));
  write_file(one.path("devices/counter.hpp"), "#include \"../common.hpp\"\n" + source);
  write_file(one.path("common.hpp"),
             "#define TEXT(x) #x\n#define TABLE(name) TEXT(tables/name.inc)\n#include TABLE(own)\n");
  write_file(one.path("tables/own.inc"), "// one\n");
  const auto is_stale = [&] { return told_by({"analyze", one.robot()}).says("FM4022"); };
  for (int times = 0; times < 2; ++times)
    REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
  CHECK_FALSE(is_stale());
  REQUIRE(run_finemote({"generate", one.robot(), "-o", one.path("generated")}).exit_status == 0);
  REQUIRE(run_finemote({"report", one.robot(), "-o", one.path("report.html")}).exit_status == 0);
  write_file(one.path("build/CMakeCache.txt"), "");
  write_file(one.path(".git/HEAD"), "one");
  CHECK_FALSE(is_stale());
  write_file(one.path("tables/own.inc"), "// two\n");
  CHECK(is_stale());
}

TEST_CASE("a file that lacks rows of the scheduler leaves its costs assumed, and of two rows the longer one counts") {
  const OneRobot one;
  Json document = Json::parse(read_file(one.timing_file()));
  const Json whole = document;
  Json& rows = document["scheduler"];
  const auto is_retry = [](const Json& row) { return row["what"] == "retry"; };
  rows.erase(std::remove_if(rows.begin(), rows.end(), is_retry), rows.end());
  write_file(one.timing_file(), document.dump());
  CHECK(told_by({"analyze", one.robot(), "--require-static"}).status == 1);

  document = whole;
  document["scheduler"].push_back({{"what", "release"}, {"wcet_ns", 1}});
  write_file(one.timing_file(), document.dump());
  const Told twice = told_by({"analyze", one.robot(), "--require-static"});
  write_file(one.timing_file(), whole.dump());
  CHECK(twice.status == 0);
  CHECK(twice.document["target"] == told_by({"analyze", one.robot()}).document["target"]);
}

TEST_CASE("another period or another device makes it stale, another comment does not") {
  const OneRobot one;
  one.describe("<!-- nothing -->");
  CHECK(told_by({"analyze", one.robot(), "--require-static"}).status == 0);
  const auto release = [&] { return told_by({"analyze", one.robot()}).document["model"]["costs"]["release_ns"]; };
  const Json of_image = release();
  one.describe("", "4ms");
  CHECK(told_by({"analyze", one.robot()}).says("FM4022"));
  CHECK(release() == of_image);  // stale costs stay: those of the board file are lower
}

TEST_CASE("__FILE__ in a user's header is as long wherever the robot lies") {
  const OneRobot one;
  const auto bound_with = [&](const std::string& rounds) {
    write_file(one.path("devices/counter.hpp"),
               "#pragma once\nclass Counter {\n public:\n  constexpr Counter() = default;\n"
               "  void update() { for (unsigned i = 0; i < " +
                   rounds +
                   "; ++i) sum_ = sum_ + i; }\n"
                   "  void handle() {}\n private:\n  unsigned volatile sum_ = 0;\n};\n");
    REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
    return bound_of(one, "update");
  };
  CHECK(bound_with("sizeof __FILE__") == bound_with("sizeof \"devices/counter.hpp\""));
}

TEST_CASE("a declared time counts where it is above the bound, and is an answer of no where it is below") {
  const OneRobot one;
  const auto declare = [&](const char* time) {
    one.describe(std::string("<wcet update=\"") + time + "\" handle=\"5us\"/>");
    REQUIRE(run_finemote({"wcet", one.robot(), "-o", one.timing_file()}).exit_status == 0);
    return told_by({"analyze", one.robot()});
  };
  const Told above = declare("15us");
  CHECK(above.status == 0);
  CHECK(above.update_ns() == 15000);
  CHECK(above.label()["label"] == "static");
  CHECK(above.label()["update_static_ns"] == bound_of(one, "update"));
  const Told below = declare("10ns");
  CHECK(below.status == 1);
  CHECK(below.says("FM4024"));
  CHECK(below.update_ns() == bound_of(one, "update"));
  CHECK(told_by({"run", one.robot(), "--duration", "50ms"}).status == 1);
  REQUIRE(run_finemote({"generate", one.robot(), "-o", one.path("out")}).exit_status == 0);
  CHECK(told_by({"check", one.robot(), "-o", one.path("out")}).status == 1);
}

TEST_CASE("a file of other arguments is left alone, and a note says so") {
  const OneRobot one;
  one.edit("\"arguments\": []", "\"arguments\": [\"rate:=2\"]");
  const Told told = told_by({"analyze", one.robot(), "--assume-wcet", "7us"});
  CHECK(told.says("FM4023"));
  CHECK(told.label()["label"] == "assumed");
  CHECK(told.update_ns() == 7000);
  CHECK(told.document["diagnostics"][0]["severity"] == "note");
}

TEST_CASE("another compiler is a note of check alone") {
  const OneRobot one;
  REQUIRE(run_finemote({"generate", one.robot(), "-o", one.path("out")}).exit_status == 0);
  const std::string compiler = Json::parse(read_file(one.timing_file()))["inputs"]["compiler"];
  one.edit(compiler, "a compiler of 1999");
  REQUIRE(run_finemote({"generate", one.robot(), "-o", one.path("out")}).exit_status == 0);
  const Told check = told_by({"check", one.robot(), "-o", one.path("out")});
  CHECK(check.status == 0);
  CHECK(check.says("'a compiler of 1999'"));
  CHECK(told_by({"analyze", one.robot(), "--require-static"}).status == 0);
}

TEST_CASE("a file that is broken is an error at its place") {
  const OneRobot one;
  const std::string good = read_file(one.timing_file());
  const auto error_of = [&](const std::string& text) {
    write_file(one.timing_file(), text);
    const auto result = run_finemote({"analyze", one.robot()});
    CHECK(result.exit_status == 2);
    return result.output;
  };
  CHECK(error_of("{").find("r.timing.json:1:2: error[FM4001]") != std::string::npos);
  CHECK(error_of("{}").find("error[FM4026]") != std::string::npos);
  CHECK(error_of("").find("error[FM0003]") != std::string::npos);
  CHECK(error_of(R"({"schema": "finemote.wcet/1"})").find("a timing file needs 'stages'") != std::string::npos);
  const std::size_t at = good.find("\"wcet_ns\": ");
  CHECK(error_of(std::string(good).replace(at, 11, "\"wcet_ns\": -")).find("error[FM4006]") != std::string::npos);
}
