// What a record of the bench kit says against its plan, and where in a file it is found.
#include "catch.hpp"
#include "generator/bench_kit/board_tests.hpp"
#include "generator/bench_kit/record.hpp"

using namespace finemote::gen;

namespace {

Board board() {
  Board result;
  result.name = "robomaster_type_c";
  result.clocks.emplace();
  result.clocks->crystal_hz = 12'000'000;
  result.clocks->flash_wait_states = 5;
  result.cpu_hz = 168'000'000;
  for (const char* name : {"usart1", "spi2", "i2c3"}) {
    result.ports.emplace_back();
    result.ports.back().name = name;
    result.ports.back().clock_hz = 84'000'000;
  }
  return result;
}

const Board kBoard = board();

BenchPlan plan() {
  return {kBoard,
          "bench",
          {{"clocks", "a.exact", 5, 5, Ground::board_file, "here"},
           {"clocks", "b.range", 10, 20, Ground::data_sheet, "there"},
           {"wire", "c.wired", 1, 1, Ground::manual, "", "jumper J1"},
           {"clocks", "d.open", 0, 0, Ground::assumed, "", "", false}},
          60};
}

std::string record(const std::string& tests, const std::string& not_done = "") {
  return R"({"schema":"finemote.bench/1","board":"robomaster_type_c","robot":"bench","plan":"0","tests":[)" + tests +
         R"(],"not_done":[)" + not_done + "]}";
}

std::string entry(const std::string& name, const std::string& value, bool ok = true) {
  return R"({"name":")" + name + R"(","value":)" + value + R"(,"expected":null,"ok":)" + (ok ? "true" : "false") + "}";
}

const std::string kGood =
    entry("a.exact", "5") + "," + entry("b.range", "20") + "," + entry("c.wired", "1") + "," + entry("d.open", "77");

/// The names of tests that differ.
std::vector<std::string> differing(const std::string& text) {
  const auto found = find_bench_record(text);
  REQUIRE(found);
  std::vector<std::string> names;
  for (const BenchVerdict& it : judge_bench(*found, plan()).tests) {
    if (!it.is_ok) names.push_back(it.name);
  }
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a record that is as expected has no difference") { CHECK(differing(record(kGood)).empty()); }

TEST_CASE("a value outside its expectation differs, at both ends") {
  const auto with = [](const std::string& range) {
    return record(entry("a.exact", "5") + "," + entry("b.range", range) + "," + entry("c.wired", "1") + "," +
                  entry("d.open", "0"));
  };
  CHECK(differing(with("10")).empty());
  CHECK(differing(with("9")) == Names{"b.range"});
  CHECK(differing(with("21")) == Names{"b.range"});
  CHECK(differing(with("null")) == Names{"b.range"});
}

TEST_CASE("the plan decides and not the record; what the image itself failed is not good either") {
  const std::string lies = R"({"name":"a.exact","value":6,"expected":6,"ok":true})";
  const std::string rest = "," + entry("b.range", "15") + "," + entry("c.wired", "1") + "," + entry("d.open", "0");
  CHECK(differing(record(lies + rest)) == Names{"a.exact"});
  CHECK(differing(record(entry("a.exact", "5", false) + rest)) == Names{"a.exact"});
}

TEST_CASE("a test that is not in the record differs, one without its jumper is not done") {
  const std::string tests = entry("a.exact", "5") + "," + entry("d.open", "1");
  const std::string lacks = R"({"name":"c.wired","why":"jumper J1"})";
  CHECK(differing(record(tests, lacks)) == Names{"b.range"});
  const auto found = find_bench_record(record(tests, lacks));
  CHECK(judge_bench(*found, plan()).not_done.size() == 1);
  CHECK(differing(record(tests, R"({"name":"b.range","why":"no time"})")) == Names{"b.range", "c.wired"});
}

TEST_CASE("a test the plan does not know is held to the record's own expectation") {
  const auto stranger = [](const char* expected) {
    return record(kGood + R"(,{"name":"z","value":3,"expected":)" + expected + R"(,"ok":true})");
  };
  CHECK(differing(stranger("3")).empty());
  CHECK(differing(stranger(R"({"min":1,"max":3})")).empty());
  CHECK(differing(stranger(R"({"min":4,"max":9})")) == Names{"z"});
}

TEST_CASE("of what a terminal wrote the last whole record counts") {
  const std::string old = record(entry("a.exact", "1")), good = record(kGood);
  CHECK(
      differing("rubbish }\r\n12 usart6 text " + old + "\n13 usart6 text " + good + "\n" + good.substr(0, 90)).empty());
  CHECK(differing(good + "\n" + old).size() == 4);
  CHECK(!find_bench_record(good.substr(0, good.size() - 1)));
  CHECK(!find_bench_record(""));
  CHECK(!find_bench_record(record(entry("a.exact", std::string(100'000, '[') + std::string(100'000, ']')))));
  CHECK(!find_bench_record("{}"));
  CHECK(!find_bench_record(R"({"schema":"finemote.bench/2","tests":[]})"));
  CHECK(!find_bench_record(R"({"schema":"finemote.bench/1","tests":[{"name":"a"}]})"));
}

TEST_CASE("expectations come from the board's file") {
  Board other = board();
  other.clocks->crystal_hz = 8'000'000;
  const auto expected = [](const Board& of, const char* name) {
    for (const BenchTest& test : board_tests(of)) {
      if (test.name == name) return expectation_of(test).dump();
    }
    return std::string();
  };
  CHECK(expected(board(), "clock.crystal_hz") == R"({"min":11520000,"max":12480000})");
  CHECK(expected(other, "clock.crystal_hz") == R"({"min":7680000,"max":8320000})");
  CHECK(expected(board(), "flash.wait_cycles_per_line") == "5");
  CHECK(expected(board(), "wire.spi_byte_ns") == R"({"min":1516,"max":1530})");  // 8 bits at 84 MHz / 16
}

TEST_CASE("a plan has another identity when a name or an expectation changes") {
  BenchPlan same = plan(), other = plan();
  other.tests[1].most = 21;
  CHECK(same.identity() == plan().identity());
  CHECK(other.identity() != plan().identity());
}
