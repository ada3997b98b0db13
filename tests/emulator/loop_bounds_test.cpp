// What the sources tell of their loops is held against what a run counts.
#include <filesystem>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

const char* const kDescriptor = R"({
  "schema": "finemote.device/1", "type": "walker", "summary": "walks lists",
  "class": "my::Walker", "header": "walker.hpp", "provides": [{ "interface": "Any" }], "params": [],
  "wcet": { "update_ns": 700000, "handle_ns": 1000 }
})";

/// A device that walks `lists` lists of `entries` entries in each update, slowly; what it says of both.
struct Walk {
  int lists = 1, entries = 1;
  int lists_told = 1, entries_told = 1;
};

std::string header_of(const Walk& walk) {
  const auto number = [](int n) { return std::to_string(n); };
  return R"(#pragma once
#include <cstdint>
#include "finemote/contract.hpp"
#include "finemote/loop_bound.hpp"
namespace my {
struct Walker {
  void update() {
    const finemote::LoopBound<)" +
         number(walk.lists_told) + R"(> lists;
    for (std::uint32_t list = 0; list < lists_; list = list + 1) {
      lists.pass();
      walk();
    }
  }
  void handle() {}
  finemote::Stamp state;

 private:
  [[gnu::noinline]] void walk() {
    const finemote::LoopBound<)" +
         number(walk.entries_told) + R"(> entries;
    for (std::uint32_t entry = 0; entry < entries_; entry = entry + 1) {
      entries.pass();
      for (unsigned wait = 0; wait < 800; ++wait) spent_ = spent_ + 1;
    }
  }
  volatile std::uint32_t lists_ = )" +
         number(walk.lists) + ", entries_ = " + number(walk.entries) + R"(, spent_ = 0;
};
}  // namespace my
)";
}

/// Two walkers, the slower of which is interrupted in its loops by the faster.
Json run_of(const Walk& walk, int status) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("devices"));
  write_file(folder.path("devices/walker.json"), kDescriptor);
  write_file(folder.path("devices/walker.hpp"), header_of(walk));
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="base"/><finemote version="1">
      <board name="robomaster_type_c"/>
      <device name="fast" type="walker" period="1ms"/> <device name="slow" type="walker" period="8ms"/>
    </finemote></robot>)");
  const auto ran = run_finemote({"run", folder.path("r.urdf"), "--duration", "100ms", "--format", "json"});
  INFO(ran.output);
  CHECK(ran.exit_status == status);
  const auto begin = ran.output.find('{');
  REQUIRE(begin != std::string::npos);
  return Json::parse(ran.output.substr(begin));
}

/// Those of the walker: of the lists, then of their entries.
std::vector<Json> loops_of(const Json& document) {
  std::vector<Json> lists, entries;
  for (const Json& loop : document["loops"]) {
    if (loop["file"].is_null() || loop["file"].get<std::string>().find("walker.hpp") == std::string::npos) continue;
    (loop["function"].get<std::string>().find("walk()") != std::string::npos ? entries : lists).push_back(loop);
  }
  lists.insert(lists.end(), entries.begin(), entries.end());
  return lists;
}

std::vector<std::string> findings_of(const Json& document) {
  std::vector<std::string> messages;
  for (const Json& finding : document["diagnostics"]) {
    if (finding["code"] == "FM6014") messages.push_back(finding["message"]);
  }
  return messages;
}

}  // namespace

TEST_CASE("marks that are true hold, in loops that the same loop interrupts, and in loops in loops") {
  const Json ran = run_of({3, 4, 3, 4}, 0);
  const std::vector<Json> loops = loops_of(ran);
  REQUIRE(loops.size() >= 2);  // more of them where the compiler has put update() into both buckets
  for (std::size_t i = 0; i < loops.size(); ++i) {
    CAPTURE(loops[i].dump());
    CHECK(loops[i]["passes_max"] == (i + 1 < loops.size() ? 3 : 4));
    CHECK(loops[i]["bound"] == loops[i]["passes_max"]);
    CHECK(loops[i]["judged"] == "held");
  }
  CHECK(findings_of(ran).empty());
}

TEST_CASE("a mark that is one too small fails the run, and says where and by how much") {
  const Json ran = run_of({3, 4, 3, 3}, 1);
  const std::vector<std::string> said = findings_of(ran);
  REQUIRE(said.size() == 1);
  CHECK(said[0].find("devices/walker.hpp:20: in 'my::Walker::walk()': the loop passed its mark 4 times, and "
                     "LoopBound<3> says at most 3") != std::string::npos);
  const std::vector<Json> loops = loops_of(ran);
  REQUIRE(loops.size() >= 2);
  for (const Json& loop : loops)
    CHECK(loop["judged"] == (loop["bound"] == 3 && loop["passes_max"] == 4 ? "broken" : "held"));
}

TEST_CASE("the loops around it are judged by themselves") {
  const Json ran = run_of({3, 4, 2, 4}, 1);
  CHECK(!findings_of(ran).empty());
  const std::vector<Json> loops = loops_of(ran);
  REQUIRE(loops.size() >= 2);
  for (const Json& loop : loops) CHECK(loop["judged"] == (loop["passes_max"] == 3 ? "broken" : "held"));
}

TEST_CASE("of a loop that never runs nothing is judged") {
  const Json ran = run_of({1, 0, 1, 1}, 0);
  const std::vector<Json> loops = loops_of(ran);
  REQUIRE(!loops.empty());
  CHECK(loops.back()["passes_max"].is_null());
  CHECK(loops.back()["judged"] == "no-sample");
}
