// The bench kit as its user meets it: written, built, run on emulated boards that are as the manual reads and on strict
// ones, and judged.
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "catch.hpp"
#include "emulator/silicon/strictness.hpp"
#include "tests/cli/program.hpp"
#include "tests/rewrites.hpp"

using namespace finemote::test;
using Names = std::set<std::string>;

namespace {

/// One kit for all tests of this file.
const std::string& kit() {
  static const TemporaryFolder folder;
  static const std::string path = [] {
    const auto ran = run_finemote({"bench-kit", "-o", folder.path("kit")});
    INFO(ran.output);
    REQUIRE(ran.exit_status == 0);
    return folder.path("kit");
  }();
  return path;
}

/// What the image of a kit prints on an emulated board, with these further words.
std::string printed_by(const std::string& folder, const std::string& words, const std::string& duration) {
  const std::string command = std::string(FINEMOTE_EMULATOR) + " --image " + folder +
                              "/build/bench.elf --board robomaster_type_c --duration " + duration + " " + words +
                              " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string output;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) output.append(buffer.data(), n);
  pclose(pipe);
  return output;
}

std::string recorded_bare(const std::string& words, const std::string& duration = "3500ms") {
  return printed_by(kit(), words, duration);
}

/// The same with its jumpers.
std::string recorded(const std::string& words = "", const std::string& duration = "3500ms") {
  return recorded_bare("--scenario " + kit() + "/jumpers.json " + words, duration);
}

struct Read {
  int status = 0;
  nlohmann::json document;
  Names differ;
};

Read read_record(const std::string& text) {
  const TemporaryFolder folder;
  write_file(folder.path("record.txt"), text);
  const auto ran = run_finemote({"bench-kit", "--read", folder.path("record.txt"), "--format", "json"});
  INFO(ran.output);
  const auto begin = ran.output.find('{');
  REQUIRE(begin != std::string::npos);
  Read read{ran.exit_status, nlohmann::json::parse(ran.output.substr(begin)), {}};
  for (const auto& test : read.document.at("tests")) {
    if (!test.at("ok").get<bool>()) read.differ.insert(test.at("name").get<std::string>());
  }
  return read;
}

constexpr const char* kReset = "the board was reset in the middle of it";

/// Why a test is not ok; empty: it is, or has a value.
std::string why_of(const Read& read, const std::string& name) {
  for (const auto& test : read.document.at("tests")) {
    if (test.at("name") == name) return test.value("why", "");
  }
  FAIL("no test " << name);
  return "";
}

/// Somebody presses the reset button at these instants [ms].
std::string recorded_with_resets(const std::vector<int>& instants) {
  const TemporaryFolder folder;
  nlohmann::json scenario = nlohmann::json::parse(read_file(kit() + "/jumpers.json"));
  for (const int ms : instants) scenario["events"].push_back({{"t_ns", ms * 1'000'000LL}, {"do", "reset"}});
  write_file(folder.path("resets.json"), scenario.dump());
  return recorded_bare("--scenario " + folder.path("resets.json"), "4s");
}

void replace_in(const std::string& path, const std::string& old, const std::string& by) {
  std::string text = read_file(path);
  const auto at = text.find(old);
  INFO(path << " has no " << old);
  REQUIRE(at != std::string::npos);
  write_file(path, text.replace(at, old.size(), by));
}

const std::map<std::string, Names> kSeen = {
    {"dma_store", {"dma.bytes_behind_count", "dma.flags_behind_count"}},
    {"dma_flag", {"dma.flags_behind_count"}},
    {"spi_busy", {"spi.busy_after_last_byte_ns"}},
    {"spi_kept", {"spi.bytes_kept"}},
    {"i2c_pause", {"i2c.late_stops"}},
    {"i2c_stop", {"i2c.stop_ns"}},
    {"can_init", {"can.initialisation_ns"}},
    {"clock_ready", {"clock.lsi_start_ns", "clock.crystal_start_ns", "clock.pll_lock_ns"}},
    {"cycle_count", {"sleep.cycles_lost_with_debug_clock"}},
    {"wake_up", {"sleep.instructions_lost"}},
    {"first_bytes", {"serial.bytes_of_noise"}},
};

std::string table_of(const nlohmann::json& document) {
  std::string table = "| test | expected | on what ground |\n|---|---|---|\n";
  for (const auto& test : document.at("tests")) {
    const auto& expected = test.at("expected");
    const std::string range = expected.is_null()     ? "nothing is claimed"
                              : expected.is_object() ? expected["min"].dump() + " to " + expected["max"].dump()
                                                     : expected.dump();
    const std::string source = test.at("source");
    table += "| `" + test.at("name").get<std::string>() + "` | " + range + " | " +
             test.at("ground").get<std::string>() + (source.empty() ? "" : ": " + source) + " |\n";
  }
  return table;
}

}  // namespace

TEST_CASE("the kit is written, built, and green on the emulated board") {
  const Read read = read_record(recorded());
  CHECK(read.differ == Names{});
  CHECK(read.status == 0);
  CHECK(read.document.at("schema") == "finemote.bench/1");
  CHECK(read.document.at("robot") == "bench");
  CHECK(read.document.at("not_done").empty());
  const auto files = files_below(kit());
  for (const char* name :
       {"CMakeLists.txt", "README.md", "jumpers.svg", "openocd/stlink.cfg", "src/main.cpp", "src/bench_plan.hpp"})
    CHECK(files.contains(name));
  CHECK(files.at("README.md").find("pyocd flash") != std::string::npos);
}

TEST_CASE("without jumpers their tests are not done, and nothing differs") {
  const Read read = read_record(recorded_bare(""));
  CHECK(read.differ == Names{});
  CHECK(read.status == 0);
  REQUIRE(read.document.at("not_done").size() == 4);  // the link of the kit sends without one
  CHECK(read.document["not_done"][0] == nlohmann::json{{"name", "wire.serial_byte_ns"}, {"why", "jumper J1"}});
}

TEST_CASE("the image judges itself as --read does") {
  const std::string output = recorded();
  const auto begin = output.find("{\"schema\"");
  REQUIRE(begin != std::string::npos);
  const auto printed = nlohmann::json::parse(output.substr(begin, output.find('\n', begin) - begin));
  const Read read = read_record(output);
  REQUIRE(printed.at("tests").size() == read.document.at("tests").size());
  for (std::size_t i = 0; i < printed.at("tests").size(); ++i) {
    for (const char* member : {"name", "value", "expected", "ok"})
      CHECK(printed["tests"][i][member] == read.document["tests"][i][member]);
  }
}

TEST_CASE("each chip that uses the freedom its manual leaves shows in its test and in no other") {
  for (const auto& info : finemote::emulator::strictnesses()) {
    INFO(info.name);
    const Read read = read_record(recorded(std::string("--silicon strict:") + info.name, "3500ms"));
    const auto seen = kSeen.find(info.name);
    CHECK(read.differ == (seen == kSeen.end() ? Names{} : seen->second));
    CHECK(read.status == (seen == kSeen.end() ? 0 : 1));
  }
}

TEST_CASE("another crystal shows") {
  const Read other = read_record(recorded("--crystal 8000000", "3500ms"));
  CHECK(other.status == 1);
  CHECK(other.differ.contains("clock.crystal_hz"));
}

TEST_CASE("a crystal that never starts is said so within a second, and what needs it is not judged") {
  const Read read = read_record(recorded("--crystal dead", "1s"));
  CHECK(read.status == 1);
  CHECK(why_of(read, "clock.crystal_start_ns") == "no answer in time");
  CHECK(why_of(read, "clock.crystal_hz") == "no answer in time");
  for (const auto& test : read.document.at("tests")) {
    const std::string name = test.at("name");
    INFO(name);
    if (name == "clock.lsi_start_ns") {
      CHECK(test.at("ok") == true);
      continue;
    }
    CHECK(test.at("ok") == false);
    CHECK(test.at("value").is_null());
    if (name.rfind("clock.crystal", 0) != 0 && name != "clock.pll_lock_ns")
      CHECK(test.at("why") == "the clock of the board does not run");
  }
}

TEST_CASE("a reset in the middle is recorded, the tests behind it run, and no number of resets keeps the record away") {
  const Read once = read_record(recorded_with_resets({40}));
  CHECK(once.differ == Names{"bmi088.accelerometer_id", "bmi088.gyroscope_id", "bmi088.accelerometer_misreads",
                             "bmi088.gyroscope_misreads"});
  for (const std::string& name : once.differ) CHECK(why_of(once, name) == kReset);
  std::vector<int> every_time;
  for (int ms = 5; ms < 400; ms += 5) every_time.push_back(ms);
  const Read often = read_record(recorded_with_resets(every_time));
  CHECK(often.status == 1);
  CHECK(why_of(often, "clock.pll_lock_ns") == kReset);
}

TEST_CASE("a kit that measures at other rates, loses a frame, and hangs in a test says so of these alone") {
  const TemporaryFolder folder;
  const std::string wrong = folder.path("kit");
  REQUIRE(run_finemote({"bench-kit", "-o", wrong}).exit_status == 0);
  replace_in(wrong + "/src/i2c_line.cpp", "kRateHz = 400'000", "kRateHz = 350'000");
  replace_in(wrong + "/src/can_line.cpp", "/ kRateHz - 1)", "/ kRateHz)");
  replace_in(wrong + "/src/can_line.cpp", "put_into(kCan, i, kIdentifier,", "put_into(kCan, i, kIdentifier + i / 2,");
  replace_in(wrong + "/src/serial.cpp", "std::uint32_t heard = 0;\n  for (const UartPins",
             "std::uint32_t heard = 0;\n  for (;;) asm volatile(\"\");\n  for (const UartPins");
  REQUIRE(finemote::gen::run_process({"cmake", "--build", wrong + "/build"}, std::chrono::seconds(200)).exit_status ==
          0);
  const Read read = read_record(printed_by(wrong, "--scenario " + wrong + "/jumpers.json", "11s"));
  CHECK(read.differ ==
        Names{"wire.i2c_byte_ns", "wire.can_frame_ns", "wire.can_wrong_frames", "serial.bytes_of_noise"});
  CHECK(why_of(read, "serial.bytes_of_noise") == kReset);
}

TEST_CASE("code without the flash accelerator takes longer, and where it never helps that shows") {
  const Names differ = read_record(recorded("--flash miss", "3500ms")).differ;
  for (const char* name : {"flash.cycles_per_100_instructions", "routine.imu_spi_ns", "routine.compass_i2c_ns",
                           "routine.motor_can_ns", "routine.serial_ns"}) {
    INFO(name);
    CHECK(differ.contains(name));
  }
}

TEST_CASE("a value that was changed in the record differs") {
  std::string output = recorded();
  const std::string was = R"("name":"bmi088.accelerometer_id","value":30)";
  const auto at = output.find(was);
  REQUIRE(at != std::string::npos);
  output.replace(at, was.size(), R"("name":"bmi088.accelerometer_id","value":31)");
  const Read read = read_record(output);
  CHECK(read.status == 1);
  CHECK(read.differ == Names{"bmi088.accelerometer_id"});
}

TEST_CASE("a record that says a thing twice, or of another board, is none") {
  const TemporaryFolder folder;
  const std::string begin = R"({"schema":"finemote.bench/1","board":"robomaster_type_c","robot":"bench","plan":"0",)";
  const std::string good = R"({"name":"a","value":1,"expected":{"min":0,"max":2},"ok":true})";
  const auto read = [&](const std::string& text) {
    write_file(folder.path("record.txt"), text);
    const auto ran = run_finemote({"bench-kit", "--read", folder.path("record.txt")});
    INFO(text << "\n" << ran.output);
    CHECK((ran.exit_status != 2 || ran.output.find("FM6013") != std::string::npos));
    return ran.exit_status;
  };
  CHECK(read(begin + R"("tests":[)" + good + "]}") == 1);  // whole, and lacks all tests of the plan
  for (const std::string& tests :
       {good + "," + good,                                                          //
        good + R"(,{"name":"a","value":9,"expected":null,"ok":false})",             //
        std::string(R"({"name":"a","value":1,"expected":"x","ok":true})"),          //
        std::string(R"({"name":"a","value":1,"expected":{"least":7},"ok":true})"),  //
        std::string(R"({"name":"a","value":1,"expected":1,"ok":false,"ok":true})"),
        std::string(R"({"name":"a","value":18446744073709551615,"expected":null,"ok":true})"),
        std::string(R"({"name":"a","value":1e3,"expected":null,"ok":true})"),
        std::string(R"({"name":"a","value":NaN,"expected":null,"ok":true})")}) {
    CHECK(read(begin + "\"tests\":[" + tests + "]}") == 2);
    CHECK(read("text\n" + begin + "\"tests\":[" + tests + "]}\n") == 2);
  }
  for (const char* not_done : {"null", "{}", "\"x\"", "[1]", "[{}]"})
    CHECK(read(begin + R"("tests":[],"not_done":)" + not_done + "}") == 2);
  CHECK(read(R"({"schema":"finemote.bench/1","board":"other","robot":"bench","plan":"0","tests":[]})") == 2);
}

TEST_CASE("a test that was done and differs is not hidden by saying that it was not done") {
  std::string output = recorded();
  const std::string name = R"({"name":"wire.spi_wrong_bytes","value":)";
  const auto at = output.find(name);
  REQUIRE(at != std::string::npos);
  output.replace(at, name.size() + 1, name + "7");
  const std::string none = R"("not_done":[)";
  const auto list = output.find(none);
  REQUIRE(list != std::string::npos);
  output.insert(list + none.size(), R"({"name":"wire.spi_wrong_bytes","why":"J2"})");
  const Read read = read_record(output);
  CHECK(read.status == 1);
  CHECK(read.differ == Names{"wire.spi_wrong_bytes"});
}

TEST_CASE("bounds of a robot whose code runs from SRAM are not those of its kit, which runs from flash") {
  const TemporaryFolder folder;
  for (const char* file : {"finsrov.urdf", "finsrov.timing.json"})
    write_file(folder.path(file), read_file(source_path(std::string("examples/") + file)));
  write_file(folder.path("record.txt"), R"({"schema":"finemote.bench/1","board":"robomaster_type_c","robot":"FinsROV",)"
                                        R"("plan":"0","tests":[]})");
  const auto limits = [&] {
    const auto ran = run_finemote(
        {"bench-kit", "--read", folder.path("record.txt"), "--robot", folder.path("finsrov.urdf"), "--format", "json"});
    INFO(ran.output);
    REQUIRE(ran.output.find('{') != std::string::npos);
    const auto document = nlohmann::json::parse(ran.output.substr(ran.output.find('{')));
    std::map<std::string, nlohmann::json> all;
    for (const auto& test : document["tests"]) all[test["name"]] = test["expected"];
    return all;
  };
  const auto with_bounds = limits();
  REQUIRE(with_bounds.contains("release.cost_ns"));
  CHECK(with_bounds.contains("stage.imu.update_ns"));
  std::filesystem::remove(folder.path("finsrov.timing.json"));
  CHECK(limits() == with_bounds);
}

TEST_CASE("what is no record is said, and so are words that go together badly") {
  const TemporaryFolder folder;
  write_file(folder.path("record.txt"), "garbage");
  const auto no_record = run_finemote({"bench-kit", "--read", folder.path("record.txt")});
  CHECK(no_record.exit_status == 2);
  CHECK(no_record.output.find("FM6013") != std::string::npos);
  CHECK(run_finemote({"bench-kit", "--read", folder.path("nothing.txt")}).exit_status == 2);
  CHECK(run_finemote({"bench-kit"}).exit_status == 2);
  CHECK(run_finemote({"bench-kit", "-o", folder.path("kit"), "--read", folder.path("record.txt")}).exit_status == 2);
  CHECK(run_finemote({"bench-kit", "-o", folder.path("kit"), "--robot", source_path("examples/discovery.urdf")})
            .exit_status == 2);
  CHECK(files_below(folder.path("kit")).empty());
}

TEST_CASE("without a compiler for the board the sources are written all the same") {
  const TemporaryFolder folder;
  const auto ran = run_finemote({"bench-kit", "-o", folder.path("kit")}, {"PATH=/nowhere"});
  INFO(ran.output);
  CHECK(ran.exit_status == 0);
  CHECK(files_below(folder.path("kit")).contains("src/main.cpp"));
  CHECK(!files_below(folder.path("kit")).contains("build/bench.elf"));
}

TEST_CASE("the page lists every test with its expectation") {
  const std::string path = source_path("docs/howto/bench-kit.md"), begin = "<!-- table: bench tests -->\n";
  std::string page = read_file(path);
  const std::size_t at = page.find(begin), end = page.find("<!-- end of table -->", at);
  REQUIRE(end != std::string::npos);
  page.replace(at + begin.size(), end - at - begin.size(), "\n" + table_of(read_record(recorded()).document) + "\n");
  if (finemote::test::rewrites()) std::ofstream(path, std::ios::binary) << page;
  CHECK(read_file(path) == page);
}
