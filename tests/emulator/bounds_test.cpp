// Robots whose bounds were once broken, or would be by a cost that is left out: everything that is judged holds, and no
// bound holds by being far too large.
#include <algorithm>
#include <sstream>
#include <string>

#include "catch.hpp"
#include "tests/emulator/judged_run.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

struct Case {
  const char* robot;     ///< in tests/emulator/bounds
  const char* duration;  ///< from the end of the bring-up on
  const char* from;      ///< start and end of the chain whose part is looked at; null: no bound is near what is seen
  const char* to;
  const char* part;
  double most;                            ///< bound by longest seen
  std::vector<std::string> options = {};  ///< of run
};

const Case kCases[] = {
    {"long_conversion", "600ms", "depth", "diver", "acquire", 1.25},
    {"lowered_clock", "600ms", "servo_0", "servo_0", "wire", 1.25},
    {"slow_stop", "200ms", "fast", "fast", "decide", 2},
    {"slow_bus", "300ms", nullptr, nullptr, nullptr, 0},
    {"preempted_wait", "600ms", nullptr, nullptr, nullptr, 0},
    {"wide_flush", "300ms", nullptr, nullptr, nullptr, 0},
    {"wide_values", "100ms", nullptr, nullptr, nullptr, 0},
    {"many_releases", "300ms", "every_30ms", "every_30ms", "decide", 2},
    {"two_frames", "600ms", "imu", "head", "decide", 4.25, {"--phases", "8", "--seed", "1"}},
    {"late_look", "600ms", "imu", "load", "acquire", 1.5, {"--phases", "8", "--seed", "2", "--silicon", "strict"}},
    {"two_sbus_frames", "600ms", nullptr, nullptr, nullptr, 0},
    {"idle_line", "600ms", "remote", "remote", "acquire", 1.25},
    {"bring_up", "300ms", nullptr, nullptr, nullptr, 0},
    {"slow_reader", "600ms", "remote", "remote", "acquire", 2},
    {"refreshed_expander", "1200ms", nullptr, nullptr, nullptr, 0},
    {"diagnosis", "300ms", nullptr, nullptr, nullptr, 0, {"--phases", "3", "--seed", "1"}},
    {"asked_servo", "600ms", "servo", "servo", "wire", 1.25},
    {"late_output", "500ms", "timer", "timer", "wire", 1.25},
    {"late_valve", "500ms", "valve", "valve", "wire", 2.25, {"--phases", "4", "--seed", "9"}},
    {"display", "500ms", "depth", "panel", "wire", 1.25, {"--phases", "4", "--seed", "9"}},
    {"commanded", "900ms", "pilot", "servo", "acquire", 1.25, {"--phases", "6", "--seed", "1"}},
    {"watcher", "3s", nullptr, nullptr, nullptr, 0},
    {"screen", "1s", nullptr, nullptr, nullptr, 0},
    {"survey", "300ms", nullptr, nullptr, nullptr, 0},
    {"slow_can", "600ms", nullptr, nullptr, nullptr, 0, {"--phases", "12", "--seed", "1"}},
};

using Ran = JudgedRun;

void check_judged(const Json& judged) {
  INFO(judged.dump());
  CHECK((judged["judged"] == "held" || judged["judged"] == "no-sample"));
}

void check_holds(const Ran& ran) {
  CHECK(ran.exit_status == 0);
  CHECK(ran.document["absent"].empty());
  CHECK(ran.document["overruns"] == 0);
  CHECK(ran.document["fault_counts"].empty());
  CHECK(ran.document["order"]["mistake"].is_null());
  REQUIRE(!ran.document["chains"].empty());
  for (const Json& chain : ran.document["chains"]) {
    for (const char* part : {"acquire", "decide", "wire", "end_to_end"}) check_judged(chain[part]);
    CHECK(chain["decide"]["judged"] == "held");
  }
  for (const char* list : {"responses", "jitter"}) {
    REQUIRE(ran.document[list].size() > 0);
    for (const Json& device : ran.document[list]) CHECK(device["judged"] == "held");
  }
}

void check_is_near(const Json& document, const Case& one) {
  for (const Json& chain : document["chains"]) {
    if (chain["from"] != one.from || chain["to"] != one.to) continue;
    const Json& part = chain[one.part];
    INFO(part.dump());
    CHECK(part["judged"] == "held");
    CHECK(part["bound_ns"].get<double>() <= one.most * part["max_ns"].get<double>());
    return;
  }
  FAIL("no such chain");
}

/// Falling edges of the key's line, `count` of them from each of these times on.
std::string edges(const std::vector<std::int64_t>& begins_ns, int count, std::int64_t apart_ns) {
  Json events = Json::array();
  for (const std::int64_t begin : begins_ns) {
    for (int i = 0; i < count; ++i) {
      events.push_back({{"t_ns", begin + i * apart_ns}, {"pin", "PA0"}, {"do", "low"}});
      events.push_back({{"t_ns", begin + i * apart_ns + apart_ns / 2}, {"pin", "PA0"}, {"do", "high"}});
    }
  }
  return Json{{"schema", "finemote.scenario/1"}, {"events", events}}.dump();
}

/// Around the releases of a period of 10 ms, some time later each.
std::vector<std::int64_t> times_about_releases() {
  std::vector<std::int64_t> times;
  for (int i = 0; i < 5; ++i) times.push_back(19'900'000 + i * 10'050'000);
  return times;
}

}  // namespace

TEST_CASE("edges of a line delay every job as often as their device declares, whether a bus carries it or not") {
  const TemporaryFolder folder;
  const std::string file = folder.path("edges.json");
  write_file(file, edges(times_about_releases(), 400, 20'400));
  check_holds(run_robot(source_path("tests/emulator/bounds/edges.urdf"), "80ms", {"--scenario", file}));
  write_file(file, edges(times_about_releases(), 20, 5'500));
  check_holds(run_robot(source_path("tests/emulator/bounds/burst.urdf"), "80ms", {"--scenario", file}));
}

TEST_CASE("more edges of pins than devices declare are said to be so") {
  const TemporaryFolder folder;
  const std::string file = folder.path("edges.json");
  write_file(file, edges(times_about_releases(), 1'100, 9'000));
  const Ran ran = run_robot(source_path("tests/emulator/bounds/edges.urdf"), "80ms", {"--scenario", file});
  CHECK(ran.exit_status == 1);
  const Json& findings = ran.document["diagnostics"];
  CHECK(std::any_of(findings.begin(), findings.end(), [](const Json& one) { return one["code"] == "FM6015"; }));
}

TEST_CASE("no age that the firmware claims is above the bound it is built with") {
  check_holds(run_robot(source_path("tests/emulator/bounds/late_silence.urdf"), "2s",
                        {"--monitor", "--phases", "8", "--seed", "3"}));
}

TEST_CASE("every bound holds on robots that come close to it") {
  for (const Case& one : kCases) {
    INFO(one.robot);
    const Ran ran =
        run_robot(source_path("tests/emulator/bounds/" + std::string(one.robot) + ".urdf"), one.duration, one.options);
    check_holds(ran);
    if (one.from != nullptr) check_is_near(ran.document, one);
  }
}

TEST_CASE("what the start-up sends is over when the first job begins") {
  check_holds(
      run_robot(source_path("tests/emulator/bounds/short_start.urdf"), "60ms", {"--phases", "5", "--seed", "1"}));
}

TEST_CASE("where an interrupt keeps the release from ending before the next one, nothing has a bound") {
  const std::string robot = source_path("tests/emulator/bounds/lost_release.urdf");
  const auto analysed = run_finemote({"analyze", robot});
  CHECK(analysed.exit_status == 1);
  CHECK(analysed.output.find("error[FM4027]: releases can be lost: their interrupt may take longer than 50us") !=
        std::string::npos);
  const Json document =
      run_robot(robot, "300ms").document;  // on the board they are lost: responses reach what nothing bounds
  CHECK(document["schedulable"] == false);
  REQUIRE(!document["responses"].empty());
  for (const Json& response : document["responses"]) CHECK(response["judged"] == "no-bound");
}

TEST_CASE("bounds include the trace that is asked for") {
  check_holds(run_robot(source_path("tests/emulator/bounds/traced.urdf"), "200ms", {"--trace"}));
}

TEST_CASE("a command that never leaves is late, whichever comes instead of it") {
  const TemporaryFolder folder;
  const std::string audit = folder.path("audit.jsonl");
  const Ran ran = run_robot(source_path("tests/emulator/bounds/busy_valve.urdf"), "300ms", {"--audit", audit});
  CHECK(ran.exit_status == 1);
  REQUIRE(ran.document["chains"].size() == 1);
  const Json& wire = ran.document["chains"][0]["wire"];
  INFO(wire.dump());
  CHECK(wire["judged"] == "broken");
  CHECK(wire["max_ns"].get<std::int64_t>() > 44'000'000);  // nine periods, and a transfer
  CHECK(wire["max_ns"].get<std::int64_t>() < 46'000'000);
  std::istringstream lines(read_file(audit));
  int sent = 0, superseded = 0;
  for (std::string line; std::getline(lines, line);) {
    const Json event = Json::parse(line);
    if (event["what"] != "superseded") continue;
    ++superseded;
    sent += event["sent"].get<bool>() ? 1 : 0;
  }
  CHECK(superseded > 45);
  CHECK(sent == superseded);
}

TEST_CASE("no latency over an overloaded bus has a bound, however urgent the frame") {
  const Json document = finemote_json({"analyze", source_path("tests/emulator/bounds/overloaded_can.urdf")});
  REQUIRE(!document["chains"].empty());
  for (const Json& chain : document["chains"]) {
    INFO(chain.dump());
    CHECK(chain["acquire_ns"].is_null());
    CHECK(chain["wire_ns"].is_null());
  }
}

TEST_CASE("every bound holds while a computer sends text without end") {
  const TemporaryFolder folder;
  Json events = Json::array();
  for (int ms = 20; ms < 400; ms += 10) {
    events.push_back({{"t_ns", ms * 1'000'000},
                      {"part", "rov.host"},
                      {"do", "send"},
                      {"text", "MOT:1500,1500,1500,1500\r\nH:31415\r\nANG:-179\r\nMOT:1501,1499,1500,1500\r\n"}});
  }
  write_file(folder.path("text.json"), Json{{"schema", "finemote.scenario/1"}, {"events", events}}.dump());
  check_holds(run_robot(source_path("examples/finsrov.urdf"), "400ms", {"--scenario", folder.path("text.json")}));
}
