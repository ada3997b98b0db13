// finemote wcet: its bounds against what the emulated board takes, and what it says where it has none.
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <map>
#include <sstream>

#include "catch.hpp"
#include "cli/program.hpp"
#include "tests/figures.hpp"

using namespace finemote;
using namespace finemote::test;
using Json = nlohmann::json;

namespace {

constexpr const char* kRobot = R"(<robot name="r"><link name="l"/><finemote version="1">
  <board name="robomaster_type_c"/><device name="own" type="counter" period="5ms"/></finemote></robot>)";

/// Sensors on SPI and I2C, an analog input, a key.
constexpr const char* kSensors = R"(<robot name="s"><link name="base_link"/><finemote version="1">
  <board name="robomaster_type_c"><param name="code">flash</param></board>
  <bus name="imu_spi" type="spi" port="spi1" clock="5250kHz"/>
  <bus name="compass_i2c" type="i2c" port="i2c3" clock="400kHz"/>
  <device name="board" type="group" period="5ms">
    <device name="imu" type="bmi088" bus="imu_spi" channel="0" period="1ms" link="base_link">
      <use role="gyro" bus="imu_spi" channel="1"/><use role="ready" pin="bmi088_int_gyro"/></device>
    <device name="compass" type="ist8310" bus="compass_i2c" link="base_link"/>
    <device name="supply" type="battery"><use role="sense" pin="battery"/></device>
    <device name="button" type="key"><use role="line" pin="key"/></device>
  </device></finemote></robot>)";

constexpr const char* kDescriptor = R"({"schema": "finemote.device/1", "type": "counter", "summary": "counts",
  "class": "Counter", "header": "counter.hpp", "provides": [], "params": [],
  "wcet": {"update_ns": 20000, "handle_ns": 1000}})";

/// A device type of a user, whose update() runs `loop`.
std::string header_with(const std::string& loop) {
  return "#pragma once\n#include <cstdint>\n#include <finemote/loop_bound.hpp>\n"
         "class Counter {\n public:\n  constexpr Counter() = default;\n"
         "  void update() {\n" +
         loop + "\n  }\n  void handle() {}\n private:\n  std::uint32_t volatile limit_ = 3, sum_ = 0;\n};\n";
}

/// What wcet says of a robot with this device.
struct Told {
  int status;
  Json document;
};

Told wcet_of(const std::string& loop) {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), kRobot);
  write_file(folder.path("devices/counter.json"), kDescriptor);
  write_file(folder.path("devices/counter.hpp"), header_with(loop));
  const auto result = run_finemote({"wcet", folder.path("r.urdf"), "--format", "json"});
  CAPTURE(result.output);
  const auto begin = result.output.find('{');
  REQUIRE(begin != std::string::npos);
  return {result.exit_status, Json::parse(result.output.substr(begin))};
}

std::int64_t update_cycles(const Told& told) {
  for (const Json& stage : told.document["stages"]) {
    if (stage["device"] == "own" && stage["stage"] == "update") return stage["wcet_cycles"];
  }
  return -1;
}

using Stages = std::map<std::pair<std::string, std::string>, std::int64_t>;

Stages longest_seen(const std::string& robot) {
  Stages seen;
  const Json run = finemote_json({"run", robot, "--flash", "miss", "--duration", "200ms"});
  for (const Json& stage : run["stages"]) {
    if (!stage["own_max_ns"].is_null()) seen[{stage["device"], stage["stage"]}] = stage["own_max_ns"];
  }
  return seen;
}

}  // namespace

TEST_CASE("params that are all 0 are known as well as others, although nothing of them is in the file") {
  const TemporaryFolder folder;
  write_file(folder.path("idle.urdf"), R"(<robot name="idle"><link name="base_link"/><finemote version="1">
  <board name="robomaster_type_c"/><device name="load" type="sim_load" period="10ms">
  <param name="update">0ns</param><param name="handle">0ns</param></device></finemote></robot>)");
  const Json bounds = finemote_json({"wcet", folder.path("idle.urdf")});
  CHECK(bounds["unresolved"].empty());
  CHECK(bounds["stages"].size() == 2);
}

TEST_CASE("no stage on the emulated board takes longer than its bound, every line of flash missed") {
  const TemporaryFolder folder;
  write_file(folder.path("sensors.urdf"), kSensors);
  for (const std::string& robot : {source_path("examples/infantry.urdf"), folder.path("sensors.urdf")}) {
    const Json bounds = finemote_json({"wcet", robot});
    const Stages seen = longest_seen(robot);
    std::size_t judged = 0;
    for (const Json& stage : bounds["stages"]) {
      const auto longest = seen.find({stage["device"], stage["stage"]});
      if (longest == seen.end()) continue;
      CAPTURE(robot, stage.dump(), longest->second);
      CHECK(longest->second <= stage["wcet_ns"].get<std::int64_t>());
      CHECK(stage["label"] == "static");
      ++judged;
    }
    CAPTURE(robot);
    CHECK(judged >= 6);
    CHECK(bounds["model"]["placement"] == (robot == folder.path("sensors.urdf") ? "flash" : "sram"));
    CHECK(bounds["inputs"]["hash"].get<std::string>().size() == 64);
  }
}

TEST_CASE("all of the larger examples has a bound, and no fault makes anything faster") {
  bool is_slower_with_faults = false;
  for (const char* example : {"examples/finsrov.urdf", "examples/six_joint_arm.urdf", "examples/discovery.urdf"}) {
    CAPTURE(example);
    const Json bounds = finemote_json({"wcet", source_path(example)});
    CHECK(bounds["unresolved"].empty());
    CHECK(bounds["stages"].size() > 10);
    for (const Json& stage : bounds["stages"])  // 0 where a stage is empty
      CHECK(stage["without_faults_ns"].get<std::int64_t>() <= stage["wcet_ns"].get<std::int64_t>());
    REQUIRE(!bounds["interrupts"].empty());
    for (const Json& interrupt : bounds["interrupts"]) {
      check_bound(interrupt["wcet_ns"], interrupt["with_faults_ns"]);
      is_slower_with_faults |= interrupt["wcet_ns"] < interrupt["with_faults_ns"];
    }
  }
  CHECK(is_slower_with_faults);
}

TEST_CASE("a loop that is made longer costs so many rounds more") {
  const Told five = wcet_of("for (int i = 0; i < 5; ++i) sum_ = sum_ + i;");
  const Told nine = wcet_of("for (int i = 0; i < 9; ++i) sum_ = sum_ + i;");
  CHECK(five.status == 0);
  CHECK(nine.status == 0);
  const std::int64_t shorter = update_cycles(five), longer = update_cycles(nine);
  REQUIRE(shorter > 0);
  CHECK(longer > shorter);
  CHECK((longer - shorter) % 4 == 0);
}

TEST_CASE("a loop without a bound is named, with its line, and its routine has no number") {
  const Told told = wcet_of("for (std::uint32_t i = 0; i < limit_; ++i) sum_ = sum_ + i;");
  CHECK(told.status == 1);
  CHECK(update_cycles(told) == -1);
  REQUIRE(told.document["unresolved"].size() == 1);
  const Json& gap = told.document["unresolved"][0];
  CHECK(gap["why"] == "a loop whose rounds are not known: bound it with LoopBound<n>");
  CHECK(gap["file"].get<std::string>().find("counter.hpp") != std::string::npos);
  CHECK(gap["line"] == 8);
  REQUIRE(gap["called_from"].size() >= 2);
  CHECK(gap["called_from"][0]["file"].get<std::string>().find("generated/") == 0);
}

TEST_CASE("a loop without a bound is named, not what lies behind the array that it goes through") {
  const std::string members =
      "\n  }\n  std::uint32_t list_[2]{};\n  const std::uint32_t behind_[4] = {1, 2, 3, 4};\n  void more() {";
  for (const auto& [rounds, why] : {std::pair<std::string, std::string>{"limit_", "a loop whose rounds are not known"},
                                    {"5", "a store to what is const"}}) {
    CAPTURE(rounds);
    const Told told =
        wcet_of("    for (std::uint32_t i = 0; i < " + rounds + "; ++i) list_[i] = sum_ * behind_[3];" + members);
    CHECK(told.status == 1);
    REQUIRE(told.document["unresolved"].size() == 1);
    CHECK(told.document["unresolved"][0]["why"].get<std::string>().rfind(why, 0) == 0);
    CHECK(told.document["unresolved"][0]["line"] == 8);
  }
}

TEST_CASE("a function of a library without a bound is told where it is called, with what stands in for it") {
  const auto why_of = [](const std::string& loop) {
    const Told told = wcet_of(loop);
    CHECK(told.status == 1);
    CAPTURE(told.document["unresolved"].dump(1));
    REQUIRE(told.document["unresolved"].size() == 1);
    const Json& gap = told.document["unresolved"][0];
    CHECK(gap["file"].get<std::string>().find("counter.hpp") != std::string::npos);
    CHECK(gap["line"] == 8);
    return gap["why"].get<std::string>();
  };
  CHECK(why_of("__builtin_memset(list_, 0, sum_ % 60);\n  }\n  unsigned char list_[64]{};\n  void more() {") ==
        "'memset' is a function of the library, and has no bound: give it a size that the compiler knows, or write "
        "the loop");
  CHECK(why_of("sum_ = static_cast<std::uint32_t>(__builtin_sinf(static_cast<float>(sum_)));") ==
        "'sinf' is a function of the library, and has no bound: use finemote::sine() of finemote/control/sine.hpp");
  CHECK(why_of("time_ = static_cast<std::int64_t>(static_cast<float>(sum_) * 1e9F);\n  }\n  std::int64_t volatile "
               "time_ = 0;\n  void more() {") ==
        "a 64-bit integer made of a 'float' has no bound on this core: make a 32-bit integer of it first");
}

TEST_CASE("a stage that has no bound because of another one of its bucket is named") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="l"/><finemote version="1">
    <board name="robomaster_type_c"/><device name="own" type="counter" period="5ms"/>
    <device name="load" type="sim_load" period="5ms"><param name="update">9us</param></device></finemote></robot>)");
  write_file(folder.path("devices/counter.json"), kDescriptor);
  write_file(folder.path("devices/counter.hpp"),
             header_with("for (std::uint32_t i = 0; i < limit_; ++i) sum_ = sum_ + i;"));
  const auto result = run_finemote({"wcet", folder.path("r.urdf")});
  CHECK(result.exit_status == 1);
  CAPTURE(result.output);
  const std::string end =
      "\nwithout a bound therefore, as a bucket is bounded as a whole\n"
      "  own.update, own.handle, load.update, load.handle\n";
  CHECK(result.output.find(end) != std::string::npos);
}

TEST_CASE("all that keeps a routine from a bound is named at once, also behind a call that cannot be followed") {
  const Told told = wcet_of(
      "reinterpret_cast<void (*)()>(limit_)();\n"
      "for (std::uint32_t i = 0; i < limit_; ++i) sum_ = sum_ + i;\n"
      "const double share = 3.0 / limit_; sum_ = static_cast<std::uint32_t>(share);");
  CHECK(told.status == 1);
  CHECK(update_cycles(told) == -1);
  std::map<int, std::string> reasons;
  for (const Json& gap : told.document["unresolved"]) {
    CHECK(gap["file"].get<std::string>().find("counter.hpp") != std::string::npos);
    reasons[gap["line"]] += gap["why"].get<std::string>();
  }
  CAPTURE(told.document["unresolved"].dump(1));
  REQUIRE(reasons.size() == 3);
  CHECK(reasons[8].find("calls what a variable says") != std::string::npos);
  CHECK(reasons[9] == "a loop whose rounds are not known: bound it with LoopBound<n>");
  CHECK(reasons[10].find("arithmetic on 'double' has no bound on this core") == 0);
}

TEST_CASE("where a loop leads in too many ways to follow, that loop is named, not the routine") {
  const Told told = wcet_of(
      "std::uint32_t x = limit_, left = limit_;\n"
      "for (std::uint32_t i = 0; i < left; ++i) {\n"
      "for (int k = 0; k < 200; ++k) { if (sum_ == x) x = x * 5 + i; if (limit_ == x) x = x / 3; }\n"
      "sum_ = x; }");
  CHECK(told.status == 1);
  REQUIRE(told.document["unresolved"].size() == 1);
  const Json& gap = told.document["unresolved"][0];
  CAPTURE(gap.dump(1));
  CHECK(gap["why"].get<std::string>().find("too many ways lead through it: this loop may turn ") == 0);
  CHECK(gap["line"] == 9);
}

TEST_CASE("a mark bounds it, and more passes cost more") {
  const auto marked = [](int passes) {
    return wcet_of("const finemote::LoopBound<" + std::to_string(passes) +
                   "> all; for (std::uint32_t i = 0; i < limit_; ++i) { all.pass(); sum_ = sum_ + i; }");
  };
  const Told three = marked(3), four = marked(4);
  CHECK(three.status == 0);
  REQUIRE(update_cycles(three) > 0);
  CHECK(update_cycles(four) > update_cycles(three));
  bool is_by_mark = false;
  for (const Json& stage : three.document["stages"]) {
    for (const Json& loop : stage["loops"]) is_by_mark |= loop["from"] == "mark" && loop["bound"] == 3;
  }
  CHECK(is_by_mark);
}

TEST_CASE("a mark that rounds can pass by is refused: it does not say which rounds are the dear ones") {
  const Told told = wcet_of(
      "const finemote::LoopBound<2> some; for (std::uint32_t i = 0; i < limit_; ++i) { if (sum_ == i) { some.pass(); "
      "sum_ "
      "= sum_ + i; } }");
  CHECK(told.status == 1);
  bool is_refused = false;
  for (const Json& gap : told.document["unresolved"])
    is_refused |= gap["why"] == "a mark that not every round of its loop passes";
  CHECK(is_refused);
}

namespace {

/// The sum of a column of the rows between two lines.
long sum_of(const std::string& text, const std::string& from, const std::string& to, int column) {
  std::istringstream rows(text.substr(text.find(from), text.find(to, text.find(from)) - text.find(from)));
  std::string row, word;
  std::getline(rows, row);
  long sum = 0;
  while (std::getline(rows, row)) {
    std::istringstream words(row);
    for (int i = 0; i <= column; ++i) words >> word;
    sum += std::atol(word.c_str());
  }
  return sum;
}

}  // namespace

TEST_CASE("every row of the table is explained to the last cycle, and a name that is none is refused") {
  const std::string robot = source_path("examples/two_devices.urdf");
  const Json bounds = finemote_json({"wcet", robot});
  const Json& stage = bounds["stages"][0];
  const std::string name = stage["device"].get<std::string>() + "." + stage["stage"].get<std::string>();
  const auto explained = run_finemote({"wcet", robot, "--explain", name});
  CHECK(explained.output.rfind(name + ": " + stage["wcet_cycles"].dump() + " cycles on the longest way\n", 0) == 0);
  for (const std::string routine : {"release", "bucket 5 ms"}) {
    const auto way = run_finemote({"wcet", robot, "--explain", routine});
    CAPTURE(way.output);
    const long cycles = std::atol(way.output.c_str() + routine.size() + 2);
    CHECK(cycles > 0);
    CHECK(sum_of(way.output, "  from", "\nby line", 1) == cycles);
    CHECK(sum_of(way.output, "    cycles   share", "\n\n", 0) <= cycles);
  }
  const auto refused = run_finemote({"wcet", robot, "--explain", "nobody.update"});
  CHECK(refused.exit_status == 2);
  CHECK(refused.output.find("no stage or routine 'nobody.update' with a bound") != std::string::npos);
}

TEST_CASE("a row that faults make longer is explained without them, too: that is what the analysis counts") {
  const std::string robot = source_path("examples/two_devices.urdf");
  const std::string text = run_finemote({"wcet", robot, "--explain", "release"}).output;
  const std::size_t at = text.find("\nrelease: ");
  REQUIRE(at != std::string::npos);
  const std::string way = text.substr(at + 1);
  CHECK(way.find(" cycles on the longest way without faults\n") != std::string::npos);
  const long cycles = std::atol(way.c_str() + std::string("release: ").size());
  CHECK(cycles < std::atol(text.c_str() + std::string("release: ").size()));
  CHECK(sum_of(way, "  from", "\nby line", 1) == cycles);
  constexpr long kMegahertz = 168;
  const Json released = finemote_json({"wcet", robot})["scheduler"][0];
  CHECK(released["wcet_ns"] == (1000 * cycles + kMegahertz - 1) / kMegahertz);
}

TEST_CASE("an image that is none is refused") {
  const TemporaryFolder folder;
  write_file(folder.path("x.elf"), "not an image");
  const auto result = run_finemote({"wcet", source_path("examples/infantry.urdf"), "--elf", folder.path("x.elf")});
  CHECK(result.exit_status == 2);
  CHECK(result.output.find("is not a linked Arm image with symbols") != std::string::npos);
}
