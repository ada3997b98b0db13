// From when on a run judges: when every part of the robot has been seen.
#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kMillisecond = 1'000'000;

const std::string kExpander = source_path("tests/emulator/bounds/bring_up.urdf");

Json stage(const Json& run, const std::string& device, const std::string& name) {
  for (const Json& one : run["stages"]) {
    if (one["device"] == device && one["stage"] == name) return one;
  }
  return {};
}

}  // namespace

TEST_CASE("a duration counts from the end of the bring-up, and so do stages") {
  const auto ran = run_finemote({"run", kExpander, "--duration", "400ms", "--format", "json"});
  INFO(ran.output);
  CHECK(ran.exit_status == 0);
  const Json run = Json::parse(ran.output.substr(ran.output.find('{')));
  CHECK(run["duration_ns"] == 400 * kMillisecond);
  CHECK(run["bringup_ns"].get<std::int64_t>() > 0);
  CHECK(run["absent"].empty());
  for (const char* name : {"update", "handle"}) {
    INFO(name);
    CHECK(std::abs(stage(run, "fast", name)["count"].get<int>() - 50) <= 1);
    CHECK(std::abs(stage(run, "slow", name)["count"].get<int>() - 10) <= 1);
  }
  REQUIRE(!run["chains"].empty());
  for (const Json& chain : run["chains"]) {
    INFO(chain.dump());
    CHECK(chain["wire"]["judged"] == "held");
  }
}

TEST_CASE("a robot without parts is up with its first release") {
  const Json run = finemote_json({"run", source_path("examples/two_devices.urdf"), "--duration", "50ms"});
  CHECK(run["bringup_ns"] == 0);
  CHECK(stage(run, "controller", "handle")["count"] == 5);
}

TEST_CASE("what measures nothing is up when its type says so") {
  const Json run = finemote_json({"run", source_path("tests/emulator/bounds/homing.urdf"), "--duration", "50ms"});
  CHECK(run["bringup_ns"] == 150 * kMillisecond);
  CHECK(std::abs(stage(run, "timer", "handle")["count"].get<int>() - 5) <= 1);
}

TEST_CASE("an expander that slow jobs set up is waited for") {
  const TemporaryFolder folder;
  write_file(folder.path("slow.urdf"), R"(<robot name="slow"><link name="base"/><finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="i2c" type="i2c" port="i2c2"/><expander name="pulses" model="pca9685" bus="i2c" address="0x40"/>
    <device name="esc" type="pwm_esc" bus="pulses" channel="0" period="400ms"/></finemote></robot>)");
  const Json run = finemote_json({"run", folder.path("slow.urdf"), "--duration", "2s"});
  CHECK(run["absent"].empty());
  CHECK(run["bringup_ns"] > 1000 * kMillisecond);
  REQUIRE(run["chains"].size() == 1);
  CHECK(run["chains"][0]["wire"]["judged"] == "held");
}

TEST_CASE("sensors that slow jobs set up step by step are waited for") {
  const TemporaryFolder folder;
  write_file(folder.path("slow.urdf"), R"(<robot name="slow"><link name="base"/><finemote version="1">
    <board name="robomaster_type_c"/>
    <bus name="spi" type="spi" port="spi1" clock="5250kHz"/><bus name="wire" type="i2c" port="i2c2"/>
    <bus name="compass" type="i2c" port="i2c3"/>
    <device name="imu" type="bmi088" bus="spi" channel="0" period="400ms"><use role="gyro" bus="spi" channel="1"/></device>
    <device name="depth" type="ms5837" bus="wire" address="0x76" period="400ms"/>
    <device name="north" type="ist8310" bus="compass" period="400ms"/></finemote></robot>)");
  const Json run = finemote_json({"run", folder.path("slow.urdf"), "--duration", "1s"});
  CHECK(run["absent"].empty());
  CHECK(run["bringup_ns"] > 4000 * kMillisecond);  // the settings of the BMI088 take a job each
}

TEST_CASE("a part that never comes up is named, and its chain has no sample") {
  const TemporaryFolder folder;
  write_file(folder.path("silent.json"), R"({"schema": "finemote.scenario/1", "events": [
      {"t_ns": 0, "part": "depth", "do": "silent"}]})");
  const std::vector<std::string> words = {"run",        source_path("tests/emulator/bounds/long_conversion.urdf"),
                                          "--duration", "100ms",
                                          "--scenario", folder.path("silent.json")};
  const Json run = finemote_json(words);
  REQUIRE(run["absent"].size() == 1);
  CHECK(run["absent"][0] == "depth");
  CHECK(run["bringup_ns"] == 1000 * kMillisecond);
  REQUIRE(!run["chains"].empty());
  for (const Json& chain : run["chains"]) {
    INFO(chain.dump());
    CHECK(chain["acquire"]["judged"] == "no-sample");
  }
  CHECK(run_finemote(words).output.find("never seen: depth") != std::string::npos);
}
