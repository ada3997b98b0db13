// The bounds in the generated files, and firmware that holds itself to them.
#include "catch.hpp"
#include "cli/program.hpp"
#include "tests/figures.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

std::string robot(const std::string& devices) {
  return R"(<robot name="r"><link name="l"/><finemote version="1"><board name="robomaster_type_c"/>)" + devices +
         "</finemote></robot>";
}

/// Two periods, commands over both; what `worker` declares and how long its update() works are given.
std::string two_periods(const std::string& declared, const std::string& work) {
  return robot(R"(<device name="top" type="sim_load" period="10ms"><wcet update="13us" handle="12us" source="budget"/>
    <device name="fast-1" type="sim_load" period="5ms"><wcet update="13us" handle="12us" source="budget"/></device>
    <device name="worker" type="sim_load"><param name="update">)" +
               work + R"(</param><wcet update=")" + declared +
               R"(" handle="30us" source="budget"/></device></device>)");
}

Json monitored(const std::string& urdf, const std::string& board) {
  TemporaryFolder folder;
  write_file(folder.path("r.urdf"), urdf);
  return finemote_json({"run", folder.path("r.urdf"), "--board", board, "--monitor"});
}

const Json& entry(const Json& run, const std::string& device) {
  for (const Json& e : run["monitor"]) {
    if (e["device"] == device) return e;
  }
  throw std::runtime_error("no monitor entry for " + device);
}

std::int64_t violations(const Json& run) {
  std::int64_t sum = 0;
  for (const Json& e : run["monitor"]) {
    sum += e["response_violations"].get<std::int64_t>() + e["age_violations"].get<std::int64_t>();
  }
  return sum;
}

/// Holds what the monitor measured against what it was given, and says whether everything was measured.
void check_quiet(const Json& run) {
  CHECK(violations(run) == 0);
  REQUIRE(run["monitor"].size() == 3);
  for (const Json& e : run["monitor"]) {
    INFO(e.dump());
    check_bound(e["response_max_ns"], e["response_bound_ns"]);
    if (e["device"] == "top") {
      CHECK(e["age_max_ns"].is_null());
    } else {
      check_bound(e["age_max_ns"], e["age_bound_ns"]);
    }
  }
}

}  // namespace

TEST_CASE("the generated files state the bounds that analyze prints") {
  TemporaryFolder folder;
  write_file(folder.path("r.urdf"), two_periods("90us", "80us"));
  REQUIRE(run_finemote({"generate", folder.path("r.urdf"), "-o", folder.path("out")}).exit_status == 0);
  const Json analysis = finemote_json({"analyze", folder.path("r.urdf"), "--chain", "fast-1->worker"});
  const std::string header = read_file(folder.path("out/schedule.hpp"));
  const auto& devices = analysis["target"]["devices"];
  REQUIRE(devices.size() == 3);
  for (std::size_t d = 0; d < devices.size(); ++d) {
    const std::string name = analysis["model"]["devices"][d]["name"].get<std::string>();
    const std::string cpp = name == "fast-1" ? "fast_1" : name;
    const std::string response = std::to_string(devices[d]["r_minus_ns"].get<std::int64_t>());
    CHECK(header.find("finemote::Bounds " + cpp + "{" + response + ",") != std::string::npos);
  }
  // The oldest data of a command: of every device with a sample of its own the worst.
  std::int64_t oldest = 0;
  for (const Json& chain : analysis["chains"]) {
    if (chain["to"] == "worker") {
      oldest = std::max(oldest, chain["acquire_ns"].get<std::int64_t>() + chain["decide_ns"].get<std::int64_t>());
    }
  }
  CHECK(header.find(", " + std::to_string(oldest) + ", ") != std::string::npos);
  CHECK(read_file(folder.path("out/trees/top.hpp")).find("/// response <= ") != std::string::npos);
}

TEST_CASE("where nothing is proven the generated files say why") {
  TemporaryFolder folder;
  write_file(folder.path("r.urdf"), two_periods("9.99ms", "80us"));
  const std::string out = folder.path("out");
  CHECK(run_finemote({"generate", folder.path("r.urdf"), "-o", out}).exit_status == 1);
  REQUIRE(run_finemote({"generate", folder.path("r.urdf"), "-o", out, "--allow-unschedulable"}).exit_status == 0);
  const std::string header = read_file(out + "/schedule.hpp");
  CHECK(header.find("no bound: a job may not have ended when the next one is due") != std::string::npos);
  CHECK(header.find("worker{finemote::kUnproven, finemote::kUnproven, finemote::kUnproven}") != std::string::npos);
  CHECK(header.find("top{finemote::kUnproven, finemote::kNothingToBound, finemote::kNothingToBound}") !=
        std::string::npos);
  CHECK(header.find("fast_1{finemote::kUnproven") == std::string::npos);  // the faster bucket keeps its bound
  CHECK(read_file(out + "/trees/top.hpp").find("no bound on the age of its command") != std::string::npos);
  CHECK(run_finemote({"check", folder.path("r.urdf"), "-o", out}).output.find("stale") == std::string::npos);
}

TEST_CASE("a robot that keeps its bounds counts no violation") {
  const std::string urdf = two_periods("90us", "80us");
  for (const std::string board : {"host", "qemu_f405", "robomaster_type_c"}) {
    INFO(board);
    check_quiet(monitored(urdf, board));
  }
}

TEST_CASE("a device that works longer than it declares is counted, and the run says no") {
  const std::string urdf = two_periods("20us", "400us");
  for (const std::string board : {"host", "qemu_f405", "robomaster_type_c"}) {
    INFO(board);
    const Json run = monitored(urdf, board);
    const Json& worker = entry(run, "worker");
    CHECK(worker["response_violations"] > 0);
    CHECK(worker["response_max_ns"].get<std::int64_t>() > worker["response_bound_ns"].get<std::int64_t>());
    CHECK(entry(run, "fast-1")["response_violations"] == 0);  // more urgent: not touched
  }
  TemporaryFolder folder;
  write_file(folder.path("r.urdf"), urdf);
  CHECK(run_finemote({"run", folder.path("r.urdf"), "--board", "host", "--monitor"}).exit_status == 1);
  CHECK(run_finemote({"run", folder.path("r.urdf"), "--board", "host"}).output.find("monitor") == std::string::npos);
}

TEST_CASE("data older than their bound are counted though every stage is in time") {
  TemporaryFolder folder;
  write_file(folder.path("devices/stale.json"), R"({"schema": "finemote.device/1", "type": "stale",
    "summary": "a sensor whose samples get old", "class": "test::Stale", "header": "stale.hpp",
    "provides": [{"interface": "test::Sample", "command": false}], "wcet": {"update_ns": 1000, "handle_ns": 500}})");
  write_file(folder.path("devices/stale.hpp"), R"(#pragma once
#include <finemote/contract.hpp>
namespace test {
struct Sample { using State = finemote::Stamp; using Command = void; };
class Stale {
 public:
  constexpr Stale() = default;
  finemote::Stamp state;
  void update() { state = {finemote::now() - 50 * finemote::kMillisecond, true}; }
  void handle() {}
};
})");
  write_file(folder.path("r.urdf"), robot(R"(<device name="top" type="sim_load" period="10ms">
    <device name="old" type="stale"/><device name="out" type="sim_load"/></device>)"));
  const Json run = finemote_json({"run", folder.path("r.urdf"), "--board", "host", "--monitor"});
  CHECK(entry(run, "out")["response_violations"] == 0);
  CHECK(entry(run, "out")["age_violations"] > 0);
  CHECK(entry(run, "out")["age_max_ns"] > 50'000'000);
}

TEST_CASE("FinsROV on its board keeps its bounds") {
  const Json run = finemote_json({"run", source_path("examples/finsrov.urdf"), "--monitor", "--duration", "200ms"});
  CHECK(violations(run) == 0);
  CHECK(run["monitor"].size() == 14);
  CHECK(entry(run, "imu")["response_max_ns"] > 0);
}
