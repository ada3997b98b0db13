// What `run` says of the emulated board: every figure beside its bound, and when the answer is no.
#include <chrono>
#include <filesystem>

#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/figures.hpp"

using namespace finemote::test;

namespace {

/// A controller every 10 ms over a sensor every 5 ms.
std::string two_devices(const std::string& sensor_params, const std::string& sensor_wcet) {
  return R"(<robot name="r"><link name="base"/><finemote version="1"><board name="robomaster_type_c"/>
      <device name="controller" type="sim_load" period="10ms">
        <param name="update">20us</param> <param name="handle">30us</param> <wcet update="25us" handle="35us"/>
        <device name="sensor" type="sim_load" period="5ms">)" +
         sensor_params + sensor_wcet + "</device></device></finemote></robot>";
}

nlohmann::json run_json(const std::string& robot, int status, const std::vector<std::string>& options = {}) {
  std::vector<std::string> words = {"run", robot, "--duration", "100ms", "--format", "json"};
  words.insert(words.end(), options.begin(), options.end());
  const auto ran = run_finemote(words);
  INFO(ran.output);
  CHECK(ran.exit_status == status);
  const auto begin = ran.output.find('{');
  REQUIRE(begin != std::string::npos);
  return nlohmann::json::parse(ran.output.substr(begin));
}

bool reports(const nlohmann::json& document, const std::string& code) {
  for (const auto& finding : document["diagnostics"]) {
    if (finding["code"] == code) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a run that is as it should be holds every figure to the bound that analyze gives") {
  const TemporaryFolder folder;
  const std::string robot = folder.path("r.urdf");
  write_file(robot, two_devices(R"(<param name="update">40us</param> <param name="handle">5us</param>)",
                                R"(<wcet update="45us" handle="10us"/>)"));
  const auto ran = run_json(robot, 0);
  const auto analysed = finemote_json({"analyze", robot});
  REQUIRE(ran["responses"].size() == 2);
  for (const auto& response : ran["responses"]) {
    INFO(response.dump());
    CHECK(response["judged"] == "held");
    check_bound(response["update_max_ns"], response["update_bound_ns"]);
    check_bound(response["handle_max_ns"], response["handle_bound_ns"]);
  }
  REQUIRE(ran["jitter"].size() == 2);
  for (const auto& jitter : ran["jitter"]) CHECK(jitter["judged"] == "held");
  REQUIRE(ran["stages"].size() == 4);
  for (const auto& stage : ran["stages"]) {
    INFO(stage.dump());
    check_bound(stage["own_max_ns"], stage["wcet_ns"]);
    CHECK(stage["wcet_label"] == "declared");
  }
  REQUIRE(!ran["chains"].empty());
  REQUIRE(ran["chains"].size() == analysed["chains"].size());
  for (std::size_t i = 0; i < ran["chains"].size(); ++i) {
    CHECK(ran["chains"][i]["decide"]["judged"] == "held");
    CHECK(ran["chains"][i]["decide"]["bound_ns"] == analysed["chains"][i]["decide_ns"]);
    CHECK(ran["chains"][i]["acquire"]["judged"] == "no-sample");  // no part that could be watched
  }
  CHECK(ran["fault_counts"].empty());
  CHECK(ran["order"]["judged"] == true);
  CHECK(ran["order"]["mistake"].is_null());
}

TEST_CASE("bounds of a run with trace or monitor are those of analyze with the same options") {
  const std::string robot = source_path("examples/two_devices.urdf");
  const auto plain = finemote_json({"analyze", robot});
  for (const char* option : {"--trace", "--monitor"}) {
    INFO(option);
    const auto ran = run_json(robot, 0, {option});
    const auto analysed = finemote_json({"analyze", robot, option});
    CHECK(ran["chains"][0]["decide"]["bound_ns"] == analysed["chains"][0]["decide_ns"]);
    CHECK(analysed["chains"][0]["decide_ns"] > plain["chains"][0]["decide_ns"]);
  }
}

TEST_CASE("a stage that takes longer by itself than its WCET fails the run") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), two_devices(R"(<param name="update">40us</param> <param name="handle">5us</param>)",
                                                R"(<wcet update="20us" handle="10us"/>)"));
  const auto ran = run_json(folder.path("r.urdf"), 1);
  CHECK(reports(ran, "FM6006"));
  CHECK(ran["overruns"] == 0);
}

TEST_CASE("overruns are those that the firmware counted") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), two_devices(R"(<param name="update">4ms</param> <param name="handle">4ms</param>)",
                                                R"(<wcet update="20us" handle="10us"/>)"));
  const auto ran = run_json(folder.path("r.urdf"), 1);
  CHECK(ran["overruns"].get<int>() > 0);
}

namespace {

const char* const kWorriedDescriptor = R"({
  "schema": "finemote.device/1", "type": "worried", "summary": "counts a fault in its twentieth update",
  "class": "my::Worried", "header": "worried.hpp",
  "provides": [{ "interface": "Any" }],
  "wcet": { "update_ns": 3000, "handle_ns": 1000 }
})";

const char* const kWorriedDevice = R"(#pragma once
#include "finemote/contract.hpp"
#include "finemote/fault.hpp"
namespace my {
struct Worried {
  void update() {
    if (++count_ == 20) finemote::count_fault(finemote::Module::device, 7);
  }
  void handle() {}
  finemote::Stamp state;

 private:
  unsigned count_ = 0;
};
}  // namespace my
)";

}  // namespace

TEST_CASE("a fault that no scenario asked for fails the run") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("devices"));
  write_file(folder.path("devices/worried.json"), kWorriedDescriptor);
  write_file(folder.path("devices/worried.hpp"), kWorriedDevice);
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="base"/><finemote version="1">
      <board name="robomaster_type_c"/><device name="worried" type="worried" period="2ms"/></finemote></robot>)");
  const auto ran = run_json(folder.path("r.urdf"), 1);
  REQUIRE(ran["fault_counts"].size() == 1);
  CHECK(ran["fault_counts"][0]["code"] == 7);
  CHECK(ran["fault_counts"][0]["count"] == 1);
  CHECK(ran["overruns"] == 0);
  CHECK(ran["responses"][0]["judged"] == "held");
  CHECK(run_finemote({"run", folder.path("r.urdf"), "--duration", "100ms"})
            .output.find("no scenario asked for these faults") != std::string::npos);
}

TEST_CASE("a bound without a sample is a no where everything has to be judged") {
  const std::string without_part = source_path("examples/two_devices.urdf");
  const auto ran = run_finemote({"run", without_part, "--duration", "100ms"});
  CHECK(ran.exit_status == 0);
  CHECK(ran.output.find("\nnot judged\n") != std::string::npos);
  CHECK(ran.output.find("acquire (no sample)") != std::string::npos);
  CHECK(run_finemote({"run", without_part, "--duration", "100ms", "--require-judged"}).exit_status == 1);
  const std::string with_part = source_path("tests/emulator/bounds/one_motor.urdf");
  CHECK(run_finemote({"run", with_part, "--duration", "100ms", "--require-judged"}).exit_status == 0);
}

TEST_CASE("the hash of an image is that of the bytes that go into the flash") {
  const TemporaryFolder folder;
  const auto built =
      finemote_json({"run", source_path("examples/two_devices.urdf"), "--build-only", "--keep", folder.path("kept")});
  const std::string bytes = folder.path("firmware.bin");
  const auto minute = std::chrono::seconds(60);
  finemote::gen::run_process({"arm-none-eabi-objcopy", "-O", "binary", folder.path("kept/build/firmware.elf"), bytes},
                             minute);
  const auto hashed = finemote::gen::run_process({"sha256sum", bytes}, minute);
  CHECK(hashed.output.substr(0, hashed.output.find(' ')) == built["image"]["sha256"]);
}

TEST_CASE("a routine that takes longer than the robot says of its bus is named, and the run fails") {
  const TemporaryFolder folder;
  const std::string robot = folder.path("r.urdf");
  const auto with = [&](const std::string& isr_wcet) {
    write_file(robot, R"(<robot name="r"><link name="base"/><finemote version="1"><board name="robomaster_type_c"/>
        <bus name="line" type="i2c" port="i2c2" clock="400kHz" isr_wcet=")" +
                          isr_wcet + R"("/>
        <device name="depth" type="ms5837" bus="line" period="10ms"/></finemote></robot>)");
    return robot;
  };
  CHECK(reports(run_json(with("2us"), 1), "FM6006"));
  CHECK_FALSE(reports(run_json(with("20us"), 0), "FM6006"));
}

TEST_CASE("a reset that a scenario asks for breaks no bound: behind it nobody knows when jobs were released") {
  const TemporaryFolder folder;
  write_file(folder.path("reset.json"),
             R"({"schema": "finemote.scenario/1", "events": [{"t_ns": 1000000, "do": "reset"}]})");
  const auto ran = finemote_json(
      {"run", source_path("examples/discovery.urdf"), "--duration", "200ms", "--scenario", folder.path("reset.json")});
  for (const auto& response : ran["responses"]) CHECK(response["judged"] == "no-sample");
  const auto text = run_finemote(
      {"run", source_path("examples/discovery.urdf"), "--duration", "200ms", "--scenario", folder.path("reset.json")});
  CHECK(text.exit_status == 0);
  CHECK(text.output.find("resets 0 beside 1 of the scenario") != std::string::npos);
}

TEST_CASE("an event that violates no assumption leaves what a line receives bounded") {
  const TemporaryFolder folder;
  write_file(folder.path("pin.json"),
             R"({"schema": "finemote.scenario/1", "events": [{"t_ns": 50000000, "pin": "PA0", "do": "high"}]})");
  const auto ran = finemote_json(
      {"run", source_path("examples/discovery.urdf"), "--duration", "60ms", "--scenario", folder.path("pin.json")});
  for (const auto& bus : ran["buses"]) {
    if (bus["name"] == "imu_line") CHECK(bus["traffic"]["most_received_ns"] > 0);
  }
}
