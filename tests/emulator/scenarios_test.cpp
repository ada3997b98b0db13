// Examples on the emulated board with plants that close their loops, and with what goes wrong on their buses: every
// scenario says itself what has to be seen at the parts, and until when.
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/figures.hpp"

using namespace finemote::test;

namespace {

std::string scenario(const std::string& name) { return source_path("tests/emulator/scenarios/" + name + ".json"); }

/// Over time a value is seen where it was wanted, and the oldest command is the worst of the chain.
void check_series(const nlohmann::json& document) {
  CHECK_FALSE(document["values"].empty());
  for (const auto& wanted : document["expectations"]) {
    INFO(wanted.dump());
    unsigned found = 0;
    for (const auto& series : document["values"]) {
      if (series["part"] != wanted["part"] || series["value"] != wanted["value"]) continue;
      ++found;
      std::int64_t at = series["from_ns"];
      const double room = 1e-5 * std::abs(wanted["max"].get<double>());  // values have six digits
      for (const auto& value : series["values"]) {
        if (at >= wanted["from_ns"] && at <= wanted["to_ns"]) {
          CHECK(value >= wanted["min"].get<double>() - room);
          CHECK(value <= wanted["max"].get<double>() + room);
        }
        at += series["every_ns"].get<std::int64_t>();
      }
      CHECK(at > wanted["from_ns"].get<std::int64_t>());
    }
    const bool is_of_family = wanted["value"].get<std::string>().rfind("noted_", 0) == 0;  // these have no series
    CHECK(found == (is_of_family ? 0U : 1U));
  }
  for (const auto& chain : document["chains"]) {
    INFO(chain.dump());
    const auto& ages = chain["ages"]["age_ns"];
    const auto& times = chain["ages"]["t_ns"];
    REQUIRE(ages.size() == times.size());
    CHECK(std::is_sorted(times.begin(), times.end()));
    if (ages.empty()) continue;
    const bool is_whole = !chain["end_to_end"]["max_ns"].is_null();
    CHECK(*std::max_element(ages.begin(), ages.end()) == chain[is_whole ? "end_to_end" : "decide"]["max_ns"]);
  }
}

nlohmann::json run_file(const std::string& robot, const std::string& name, const std::string& duration,
                        std::size_t expectations) {
  INFO(robot << ", " << name);
  const auto document = finemote_json({"run", robot, "--scenario", scenario(name), "--duration", duration});
  CHECK(document["expectations"].size() == expectations);
  for (const auto& it : document["expectations"]) {
    INFO(it.dump());
    CHECK(it["ok"] == true);
  }
  check_series(document);
  CHECK(document["overruns"] == 0);
  CHECK(document["resets"] == 0);
  if (document["faults"] == true) return document;  // bounds presume that parts and wires work
  unsigned compared = 0;
  for (const auto& chain : document["chains"]) {
    INFO(chain.dump());
    for (const char* part : {"acquire", "decide", "wire", "end_to_end"}) {
      const auto& figure = chain[part];
      if (figure["max_ns"].is_null() || figure["bound_ns"].is_null()) continue;
      check_bound(figure["max_ns"], figure["bound_ns"]);
      ++compared;
    }
  }
  CHECK(compared > 0);
  return document;
}

nlohmann::json run(const std::string& robot, const std::string& name, const std::string& duration,
                   std::size_t expectations) {
  return run_file(source_path("examples/" + robot + ".urdf"), name, duration, expectations);
}

/// Puts `now` in place of the first `was` after `mark`.
void change(std::string& text, const std::string& mark, const std::string& was, const std::string& now) {
  const std::size_t at = text.find(was, text.find(mark));
  REQUIRE(at != std::string::npos);
  text.replace(at, was.size(), now);
}

}  // namespace

TEST_CASE("the underwater vehicle dives, turns, and comes back from a push") { run("finsrov", "rov_loops", "14s", 9); }

TEST_CASE("thrusters on headers of the board and on an expander obey within their bounds") {
  const TemporaryFolder folder;
  std::string robot = read_file(source_path("examples/finsrov.urdf"));
  for (int n = 1; n <= 4; ++n) {
    const std::string number = std::to_string(n);
    change(robot, "<bus name=\"i2c\"", "<bus",
           "<bus name=\"out" + number + "\" type=\"pwm\" port=\"pwm" + number + "\"/>\n    <bus");
    change(robot, "<device name=\"thruster_" + number, "bus=\"pwm\" channel=\"" + std::to_string(n - 1) + "\"",
           "bus=\"out" + number + "\"");
  }
  write_file(folder.path("mixed.urdf"), robot);
  const auto document = run_file(folder.path("mixed.urdf"), "rov_loops", "14s", 9);
  unsigned chains = 0;
  for (const auto& chain : document["chains"]) {
    if (chain["to"].get<std::string>().rfind("thruster_", 0) != 0 || chain["from"] != "imu") continue;
    INFO(chain.dump());
    CHECK(!chain["wire"]["max_ns"].is_null());  // there were commands that changed the pulse
    CHECK(!chain["wire"]["bound_ns"].is_null());
    ++chains;
  }
  CHECK(chains == 8);
}

TEST_CASE("robots of all device types meet their schedules, bounds and default execution times") {
  for (const char* robot : {"rover", "rig", "crane"}) {
    const std::string file = source_path("tests/emulator/robots/" + std::string(robot) + ".urdf");
    INFO(file);
    const auto document = finemote_json({"run", file, "--duration", "400ms"});
    CHECK(document["overruns"] == 0);
    CHECK(document["resets"] == 0);
    CHECK(document["chains"].size() >= 2);
    for (const auto& finding : document["diagnostics"]) {
      INFO(finding.dump());
      CHECK(finding["code"] != "FM6006");  // the shortest run seen takes longer than the default says
    }
  }
}

TEST_CASE("the infantry drives where its sticks say and its head holds its aim against the world") {
  run("infantry", "infantry_loops", "5200ms", 18);
}

TEST_CASE("the infantry moves the same with motors and encoders turned and a sensor on its side") {
  const TemporaryFolder folder;
  std::string robot = read_file(source_path("examples/infantry.urdf"));
  for (const char* joint : {"wheel_front_right_joint", "wheel_rear_right_joint", "pitch_joint"})
    change(robot, std::string("\"") + joint + "\" type", "0 1 0", "0 -1 0");
  change(robot, "\"yaw_joint\" type", "0 0 1\"/>", "0 0 -1\"/>");
  change(robot, "\"pitch_joint\" type", R"(lower="-0.6" upper="0.7")", R"(lower="-0.7" upper="0.6")");
  change(robot, "\"imu_joint\"", R"(xyz="0.02 0 0.03")", R"(xyz="0.02 0 0.03" rpy="1.5708 0 -1.5708")");
  change(robot, "joint=\"pitch_joint\"", "/>", R"(><param name="zero">4.5</param></device>)");
  write_file(folder.path("other.urdf"), robot);
  run_file(folder.path("other.urdf"), "infantry_other_way", "4s", 10);
}

TEST_CASE("the arm's joints go where they are jogged and hold against a load") {
  run("six_joint_arm", "arm_loops", "6s", 8);
}

TEST_CASE(
    "whatever fails on the underwater vehicle's buses, its thrusters are neutral within a bound, and work again "
    "after") {
  run("finsrov", "rov_faults", "9800ms", 17);
}

TEST_CASE("whatever fails on the infantry's buses, its motors have no current within a bound, and work again after") {
  const auto document = run("infantry", "infantry_faults", "4300ms", 15);
  // A command that arrives after frames were destroyed is not one that has waited: what a wheel is driven by is never
  // older than a composite takes.
  unsigned chains = 0;
  for (const auto& chain : document["chains"]) {
    if (chain["from"] != "front_left") continue;  // what was silent itself is behind zeros only
    INFO(chain.dump());
    CHECK(chain["end_to_end"]["max_ns"].get<std::int64_t>() <= 25'000'000);
    ++chains;
  }
  CHECK(chains == 4);
}

TEST_CASE(
    "PWM part, mux, damaged frames, lost arbitration and DMA errors cost the vehicle its thrust for a bounded time") {
  run("finsrov", "rov_more_faults", "7500ms", 14);
}

TEST_CASE("damaged frames, silent controllers, a cut bus and a restarted sensor leave the infantry without current") {
  run("infantry", "infantry_more_faults", "5s", 28);
}

TEST_CASE("without its data-ready line or its sensor the infantry's head has no current, and the sensor no heat") {
  run("infantry", "infantry_imu", "7500ms", 10);
}

TEST_CASE("whatever fails at the arm's receiver, buses and motors, its joints have no torque within a bound") {
  run("six_joint_arm", "arm_faults", "6s", 36);
}

TEST_CASE("what a dead computer sent before is not obeyed again when the reception of its line is restarted") {
  run_file(source_path("tests/emulator/robots/remote.urdf"), "remote_faults", "3s", 2);
}

TEST_CASE("the first pulse after a reset is the safe one, whatever the first job commands") {
  run_file(source_path("tests/emulator/robots/remote.urdf"), "remote_reset", "1300ms", 2);
}

TEST_CASE("a chassis of the user's own moves on wheels whose motors are in composites") {
  const auto document =
      finemote_json({"run", source_path("tests/emulator/composite_wheels/robot.urdf"), "--scenario",
                     source_path("tests/emulator/composite_wheels/straight.json"), "--duration", "800ms"});
  CHECK(document["expectations"].size() == 3);
  for (const auto& it : document["expectations"]) {
    INFO(it.dump());
    CHECK(it["ok"] == true);
  }
}

TEST_CASE("a robot of another board runs on the emulated chip, wired as that board") {
  const auto document = finemote_json({"run", source_path("examples/discovery.urdf"), "--duration", "400ms"});
  CHECK(document["board"] == "stm32f4_discovery");
  CHECK(document["overruns"] == 0);
  CHECK(document["diagnostics"].empty());
}

TEST_CASE("a board that lacks a port of the robot does not play it") {
  const auto run = run_finemote({"run", source_path("examples/discovery.urdf"), "--board", "robomaster_type_c"});
  CHECK(run.exit_status == 2);
  CHECK(run.output.find("board 'robomaster_type_c' has no port 'usart2'") != std::string::npos);
}

TEST_CASE("a run that is not as its scenario expects is a no, one that cannot happen is an error") {
  const TemporaryFolder folder;
  const std::string robot = source_path("examples/two_devices.urdf");
  const auto with = [&](const std::string& text) {
    write_file(folder.path("s.json"), R"({"schema": "finemote.scenario/1", )" + text + "}");
    return run_finemote({"run", robot, "--scenario", folder.path("s.json"), "--duration", "50ms"});
  };
  const auto wrong = with(R"("parts": [{"type": "standing_body", "name": "hand"}],
                             "expect": [{"from_ns": 30000000, "part": "hand", "value": "yaw", "min": 1, "max": 2}])");
  CHECK(wrong.exit_status == 1);
  CHECK(wrong.output.find("NOT AS EXPECTED") != std::string::npos);
  const auto late = with(R"("parts": [{"type": "standing_body", "name": "hand"}],
                            "expect": [{"from_ns": 90000000, "part": "hand", "value": "yaw", "min": -1, "max": 2}])");
  CHECK(late.exit_status == 1);
  CHECK(late.output.find("the run ended before") != std::string::npos);
  const auto impossible = with(R"("parts": [{"type": "standing_body", "name": "hand"}],
                                  "events": [{"t_ns": 30000000, "part": "hand", "do": "explode"}])");
  CHECK(impossible.exit_status == 2);
  CHECK(impossible.output.find("FM6007") != std::string::npos);
  // An event after the end lengthens the run; what is looked at until then is judged.
  const auto longer = with(R"("parts": [{"type": "standing_body", "name": "hand"}],
                              "events": [{"t_ns": 120000000, "part": "hand", "do": "move", "yaw": 5}],
                              "expect": [{"from_ns": 90000000, "part": "hand", "value": "yaw", "min": -1, "max": 2}])");
  CHECK(longer.exit_status == 0);
  // Parts that cannot be wired are found before anything is compiled.
  const auto twice = with(R"("parts": [{"type": "thruster", "name": "t", "port": "pwm1", "min": 1600000}])");
  CHECK(twice.exit_status == 2);
  CHECK(twice.output.find("'neutral' must be between 'min', 1600000 ns") != std::string::npos);
}

TEST_CASE("times of a scenario count from the first release") {
  const TemporaryFolder folder;
  const std::string text =
      R"({"schema": "finemote.scenario/1", "events": [{"t_ns": 0, "part": "imu", "do": "silent"}]})";
  write_file(folder.path("s.json"), text);
  run_finemote({"run", source_path("examples/finsrov.urdf"), "--scenario", folder.path("s.json"), "--duration", "10ms",
                "--audit", folder.path("audit.jsonl")});
  // Its last frame came while the board started, within an interval of 5 ms before the first release. Silence since
  // power-on would leave none.
  std::optional<std::int64_t> last_ps;
  std::istringstream lines(read_file(folder.path("audit.jsonl")));
  for (std::string line; std::getline(lines, line);) {
    const auto event = nlohmann::json::parse(line);
    if (event["what"] == "sample" && event["part"] == "imu") last_ps = event["t"].get<std::int64_t>();
  }
  REQUIRE(last_ps);
  CHECK(*last_ps > -6'000'000'000);
  CHECK(*last_ps < 1'000'000'000);
}

TEST_CASE("bounds hold with every fetch from flash missed when execution times are declared for that") {
  const TemporaryFolder folder;
  const auto robot_with = [&](const std::string& fast, const std::string& slow) {
    const auto load = [](const std::string& name, const std::string& period, const std::string& wcet,
                         const std::string& children) {
      return "<device name=\"" + name + "\" type=\"sim_load\" period=\"" + period + "\">" + wcet +
             "<param name=\"update\">20us</param> <param name=\"handle\">20us</param>" + children + "</device>";
    };
    write_file(folder.path("r.urdf"),
               R"(<robot name="r"><link name="base"/><finemote version="1">
                   <board name="robomaster_type_c"><param name="code">flash</param></board>)" +
                   load("slow", "5ms", slow, load("fast", "1ms", fast, "") + load("other", "2ms", fast, "")) +
                   "</finemote></robot>");
    return folder.path("r.urdf");
  };
  const auto run = [](const std::string& robot, const std::string& flash) {
    return run_finemote({"run", robot, "--flash", flash, "--duration", "200ms"});
  };
  // A loop that lies across two lines of the flash takes three times as long as one within a line.
  const std::string roomy = R"(<wcet update="100us" handle="100us" source="measured"/>)";
  const auto holds = run(robot_with(roomy, roomy), "miss");
  INFO(holds.output);
  CHECK(holds.exit_status == 0);
  CHECK(holds.output.find("FM6006") == std::string::npos);
  CHECK(holds.output.find("bounds are those of the execution times that the robot has") != std::string::npos);

  const std::string tight = R"(<wcet update="22us" handle="22us" source="measured"/>)";
  CHECK(run(robot_with(tight, tight), "hit").output.find("FM6006") == std::string::npos);
  const auto late = run(robot_with(tight, tight), "miss");
  INFO(late.output);
  CHECK(late.output.find("FM6006") != std::string::npos);
}
