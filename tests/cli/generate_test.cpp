// finemote generate: same input, same bytes, and nothing half-done.
#include "catch.hpp"
#include "cli/program.hpp"

#include <filesystem>

using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

const char* const kRobot = R"(<robot name="twin"><link name="base_link"/>
<finemote version="1">
  <board name="robomaster_type_c"/>
  <device name="a" type="sim_load" period="10ms"><device name="a1" type="sim_load"/></device>
  <device name="b" type="sim_load" period="5ms"/>
</finemote></robot>
)";

}  // namespace

TEST_CASE("the same input gives the same bytes from another folder, in another locale, a second time") {
  for (const std::string& robot : example_robots()) {
    INFO(robot);
    TemporaryFolder folder;
    const std::string input = source_path("examples/" + robot);
    REQUIRE(run_finemote({"generate", input, "-o", folder.path("one")}).exit_status == 0);
    const auto first = files_below(folder.path("one"));
    REQUIRE(first.size() >= 7);

    REQUIRE(
        run_finemote({"generate", input, "-o", folder.path("two")}, {"LOCPATH=" FINEMOTE_LOCALES, "LC_ALL=de_DE.UTF-8"})
            .exit_status == 0);
    CHECK(files_below(folder.path("two")) == first);

    const fs::path before = fs::current_path();
    fs::current_path(source_path("examples"));
    CHECK(run_finemote({"generate", robot, "-o", folder.path("three")}).exit_status == 0);
    fs::current_path(before);
    CHECK(files_below(folder.path("three")) == first);
  }
}

TEST_CASE("a file whose bytes are right is not touched, a changed one is mended, a left-over one is removed") {
  TemporaryFolder folder;
  write_file(folder.path("twin.urdf"), kRobot);
  REQUIRE(run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("out")}).exit_status == 0);
  const auto files = files_below(folder.path("out"));
  const auto stamp = fs::last_write_time(folder.path("out/schedule.cpp"));
  fs::remove(folder.path("out/trees/a.cpp"));
  write_file(folder.path("out/mine.txt"), "the user's own file");
  REQUIRE(run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("out")}).exit_status == 0);
  CHECK(fs::last_write_time(folder.path("out/schedule.cpp")) == stamp);
  CHECK(read_file(folder.path("out/trees/a.cpp")) == files.at("trees/a.cpp"));

  std::string renamed = kRobot;
  renamed.replace(renamed.find("name=\"b\""), 8, "name=\"c\"");
  write_file(folder.path("twin.urdf"), renamed);
  REQUIRE(run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("out")}).exit_status == 0);
  CHECK_FALSE(fs::exists(folder.path("out/trees/b.cpp")));
  CHECK(fs::exists(folder.path("out/trees/c.cpp")));
  CHECK(read_file(folder.path("out/mine.txt")) == "the user's own file");
}

TEST_CASE("an invalid robot writes nothing") {
  TemporaryFolder folder;
  write_file(folder.path("bad.urdf"),
             "<robot name='r'><finemote version='1'><board name='nowhere'/></finemote></robot>");
  const auto result = run_finemote({"generate", folder.path("bad.urdf"), "-o", folder.path("out")});
  CHECK(result.exit_status == 2);
  CHECK(result.output.find("nowhere") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path("out")));
}

TEST_CASE("two robots do not share a folder, and a link is no folder") {
  TemporaryFolder folder;
  write_file(folder.path("twin.urdf"), kRobot);
  std::string other = kRobot;
  other.replace(other.find("twin"), 4, "solo");
  write_file(folder.path("solo.urdf"), other);
  REQUIRE(run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("out")}).exit_status == 0);
  const auto before = files_below(folder.path("out"));
  const auto result = run_finemote({"generate", folder.path("solo.urdf"), "-o", folder.path("out")});
  CHECK(result.exit_status == 2);
  CHECK(result.output.find("FM5003") != std::string::npos);
  CHECK(files_below(folder.path("out")) == before);

  fs::create_directory_symlink(folder.path("out"), folder.path("link"));
  const auto linked = run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("link")});
  CHECK(linked.exit_status == 2);
  CHECK(linked.output.find("FM5002") != std::string::npos);
}

TEST_CASE("--list names exactly the files that are written, --dry-run writes none, --depfile names every input") {
  TemporaryFolder folder;
  write_file(folder.path("twin.urdf"), kRobot);
  const auto dry = run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("out"), "--dry-run"});
  CHECK(dry.exit_status == 0);
  CHECK_FALSE(fs::exists(folder.path("out")));
  const auto list = run_finemote({"generate", folder.path("twin.urdf"), "--list"});
  REQUIRE(run_finemote({"generate", folder.path("twin.urdf"), "-o", folder.path("out"), "--depfile", folder.path("d")})
              .exit_status == 0);
  std::string names;
  for (const auto& [name, text] : files_below(folder.path("out"))) {
    CHECK(list.output.find(name + "\n") != std::string::npos);
    names += name + "\n";
  }
  CHECK(names.size() == list.output.size());
  const std::string rule = read_file(folder.path("d"));
  CHECK(rule.find(folder.path("twin.urdf")) != std::string::npos);
  CHECK(rule.find("sim_load.json") != std::string::npos);
  CHECK(rule.find("robomaster_type_c.json") != std::string::npos);
  CHECK(rule.find("stm32f407.json") != std::string::npos);  // which the board extends
}

TEST_CASE("FinsROV written with macros is FinsROV") {
  TemporaryFolder folder;
  const auto result =
      finemote_json({"diff", source_path("examples/finsrov.urdf"), source_path("examples/finsrov.urdf.xacro")});
  CHECK(result["changes"].empty());
  REQUIRE(run_finemote({"generate", source_path("examples/finsrov.urdf"), "-o", folder.path("plain")}).exit_status ==
          0);
  REQUIRE(
      run_finemote({"generate", source_path("examples/finsrov.urdf.xacro"), "-o", folder.path("xacro")}).exit_status ==
      0);
  auto plain = files_below(folder.path("plain"));
  auto expanded = files_below(folder.path("xacro"));
  plain.erase("finemote.manifest.json");
  expanded.erase("finemote.manifest.json");
  for (auto& [name, text] : expanded) {
    const auto suffix = text.find(".urdf.xacro\n");
    REQUIRE(suffix != std::string::npos);
    text.erase(suffix + 5, 6);
  }
  CHECK(plain == expanded);
}

TEST_CASE("the clock mode of a part on SPI and the patience of the watchdog arrive in the generated files") {
  TemporaryFolder folder;
  fs::create_directories(folder.path("devices"));
  write_file(folder.path("devices/gauge.hpp"), "#pragma once\n");
  write_file(folder.path("devices/gauge.json"), R"({
  "schema": "finemote.device/1", "type": "gauge", "summary": "for tests", "class": "Gauge", "header": "gauge.hpp",
  "bus": { "types": ["spi"], "channel": {}, "mode": 1 },
  "uses": [{ "name": "memory", "types": ["spi"], "mode": 0 }, { "name": "more", "types": ["spi"] }]
})");
  write_file(folder.path("robot.urdf"), R"(<robot name="twin"><finemote version="1">
  <board name="robomaster_type_c"><param name="watchdog_periods">7</param></board>
  <bus name="spi" type="spi" port="spi1" clock="5250kHz"/><bus name="other" type="spi" port="spi2" clock="5250kHz"/>
  <device name="gauge" type="gauge" period="10ms" bus="spi" channel="0">
    <use role="memory" bus="spi" channel="1"/><use role="more" bus="other"/>
  </device>
  <device name="imu" type="sim_load" period="5ms"/>
</finemote></robot>
)");
  // Two busy SPI buses are too much for the processor; what is generated for them is the question here.
  REQUIRE(run_finemote({"generate", folder.path("robot.urdf"), "-o", folder.path("out"), "--allow-unschedulable"})
              .exit_status == 0);
  const std::string buses = read_file(folder.path("out/buses.cpp"));
  CHECK(buses.find("gauge{spi, 0x00, /*priority*/ 1, /*mode*/ 1}") != std::string::npos);
  CHECK(buses.find("gauge_memory{spi, 0x01, /*priority*/ 1, /*mode*/ 0}") != std::string::npos);
  CHECK(buses.find("gauge_more{other, 0x00, /*priority*/ 1, /*mode*/ 1}") != std::string::npos);
  const std::string schedule = read_file(folder.path("out/schedule.cpp"));
  CHECK(schedule.find("5 * finemote::kMillisecond, 48, 4, 7}") != std::string::npos);
  CHECK(schedule.find("10 * finemote::kMillisecond, 49, 5, 7}") != std::string::npos);
}

TEST_CASE("a param of the board outside its range is refused") {
  TemporaryFolder folder;
  write_file(folder.path("robot.urdf"), R"(<robot name="twin"><finemote version="1">
  <board name="robomaster_type_c"><param name="watchdog_periods">101</param></board>
  <device name="imu" type="sim_load" period="5ms"/>
</finemote></robot>
)");
  const auto result = run_finemote({"generate", folder.path("robot.urdf"), "-o", folder.path("out")});
  CHECK(result.exit_status == 2);
  CHECK(result.output.find("FM3026") != std::string::npos);
}
