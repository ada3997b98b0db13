// The bench kit as its user meets it: written, built, run on emulated boards that are as the manual reads and on meaner
// ones, and judged.
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "catch.hpp"
#include "emulator/silicon/meanness.hpp"
#include "tests/cli/program.hpp"

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

/// What the image prints on an emulated board, with these further words.
std::string recorded_bare(const std::string& words, const std::string& duration = "3500ms") {
  const std::string command = std::string(FINEMOTE_EMULATOR) + " --image " + kit() +
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

const std::map<std::string, Names> kSeen = {
    {"dma_store", {"dma.bytes_behind_count", "dma.flags_behind_count"}},
    {"dma_flag", {"dma.flags_behind_count"}},
    {"spi_busy", {"spi.busy_after_last_byte_ns"}},
    {"spi_kept", {"spi.bytes_kept"}},
    {"i2c_pause", {"i2c.late_stops"}},
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
  REQUIRE(read.document.at("not_done").size() == 4);
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

TEST_CASE("each chip that is meaner than its manual shows in its test and in no other") {
  for (const auto& info : finemote::emulator::meannesses()) {
    INFO(info.name);
    const Read read = read_record(recorded(std::string("--silicon strict:") + info.name, "3500ms"));
    const auto seen = kSeen.find(info.name);
    CHECK(read.differ == (seen == kSeen.end() ? Names{} : seen->second));
    CHECK(read.status == (seen == kSeen.end() ? 0 : 1));
  }
}

TEST_CASE("another crystal shows, and one that does not start leaves a record all the same") {
  const Read other = read_record(recorded("--crystal 8000000", "3500ms"));
  CHECK(other.status == 1);
  CHECK(other.differ.contains("clock.crystal_hz"));
}

TEST_CASE("code without the flash accelerator takes longer, and where it never helps that shows") {
  CHECK(read_record(recorded("--flash miss", "3500ms")).differ.contains("flash.cycles_per_100_instructions"));
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
  if (std::getenv("FINEMOTE_UPDATE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << page;
  CHECK(read_file(path) == page);
}
