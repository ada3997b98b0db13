// What a run must not overlook: what no default chain passes, what comes too late to be measured, and what a scenario
// excuses only from when it happens.
#include <algorithm>

#include "catch.hpp"
#include "tests/emulator/judged_run.hpp"

using namespace finemote::test;
using Json = nlohmann::json;

namespace {

const std::string kOrder = R"({"t_ns": 100000000, "part": "rov.host", "do": "send", "text": "ON"})";
const std::string kJump = R"({"t_ns": 700000000, "part": "baro_1", "do": "move", "pressure": 200000})";

/// A noisy line, long after the jump or before it.
std::string damage_at(const std::string& t_ns) {
  return R"({"t_ns": )" + t_ns + R"(, "part": "imu", "do": "damage", "frames": 1})";
}
std::string refusal_at(const std::string& t_ns) {
  return R"({"t_ns": )" + t_ns + R"(, "port": "i2c2", "do": "nack", "address": 118, "times": 1})";
}

/// Parts of chains that are above their bounds.
std::vector<Json> broken(const JudgedRun& ran) {
  std::vector<Json> all;
  for (const Json& chain : ran.document["chains"]) {
    for (const char* part : {"acquire", "decide", "wire", "end_to_end"}) {
      if (chain[part]["judged"] == "broken") all.push_back(chain[part]);
    }
  }
  return all;
}

JudgedRun run_blind(const std::string& name, const std::string& duration,
                    const std::vector<std::string>& options = {}) {
  return run_robot(source_path("tests/emulator/blind_spots/" + name + ".urdf"), duration, options);
}

/// With a scenario of these events and expectations.
JudgedRun run_finsrov(const std::string& events, const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  const std::string path = folder.path("scenario.json");
  write_file(path, R"({"schema": "finemote.scenario/1", "events": [)" + events + "]}");
  std::vector<std::string> words = {"--scenario", path};
  words.insert(words.end(), options.begin(), options.end());
  return run_robot(source_path("examples/finsrov.urdf"), "1s", words);
}

}  // namespace

TEST_CASE("a sensor that no default chain begins at is judged as well") {
  const JudgedRun calm = run_finsrov(kOrder);
  CHECK(calm.exit_status == 0);
  CHECK(broken(calm).empty());
  const JudgedRun jump = run_finsrov(kOrder + "," + kJump);  // the sensor refuses it, and keeps its depth
  CHECK(jump.exit_status == 1);
  REQUIRE(!broken(jump).empty());
  CHECK(jump.document["chains"].size() > calm.document["chains"].size());
}

TEST_CASE("what was broken before a fault is not excused by it") {
  const std::string jump = kOrder + "," + kJump + ",";
  for (const std::string& late : {damage_at("1110000000"), refusal_at("1110000000")}) {
    const JudgedRun ran = run_finsrov(jump + late);
    CHECK(ran.exit_status == 1);
    REQUIRE(!broken(ran).empty());
    for (const Json& part : broken(ran)) CHECK_FALSE(part.contains("assumption"));
  }
  CHECK(run_finsrov(jump + damage_at("1110000000"), {"--monitor"}).exit_status == 1);
  // A bus that has to be recovered can delay everything; an error of a line touches what goes over it.
  const JudgedRun excused = run_finsrov(kOrder + "," + refusal_at("690000000") + "," + kJump);
  CHECK(excused.exit_status == 0);
  REQUIRE(!broken(excused).empty());
  for (const Json& part : broken(excused)) CHECK(part["assumption"] == "bus-errors");
  CHECK(run_finsrov(kOrder + "," + damage_at("690000000") + "," + kJump).exit_status == 1);
}

TEST_CASE("an actuator that is no leaf has to be judged where everything has to be") {
  const JudgedRun ran = run_blind("encoder", "300ms", {"--require-judged"});
  CHECK(ran.exit_status == 1);
  CHECK(broken(ran).empty());
  const Json& chains = ran.document["chains"];
  const auto motor = std::find_if(chains.begin(), chains.end(), [](const Json& c) { return c["to"] == "motor"; });
  REQUIRE(motor != chains.end());
  CHECK((*motor)["wire"]["judged"] == "no-sample");
}

TEST_CASE("data that a device calls valid may not look older by their time stamp than such data can") {
  const auto far_from = [](const std::string& t_ns) {
    const TemporaryFolder folder;
    write_file(folder.path("far.json"), R"({"schema": "finemote.scenario/1", "events": [{"t_ns": )" + t_ns +
                                            R"(, "part": "echo", "do": "set", "r81": 255}]})");
    return run_blind("encoder", "300ms", {"--scenario", folder.path("far.json")});
  };
  const JudgedRun good = run_blind("encoder", "300ms");
  CHECK(good.exit_status == 0);
  CHECK(good.of("claims", "echo")["judged"] == "held");
  const JudgedRun refused = far_from("200000000");  // it keeps what it had, and says so
  CHECK(refused.exit_status == 1);
  CHECK(broken(refused).empty());
  const Json claim = refused.of("claims", "echo");
  CHECK(claim["judged"] == "broken");
  CHECK(claim["lead_max_ns"].get<std::int64_t>() <= 1000);
  CHECK(claim["age_max_ns"].get<std::int64_t>() > 90'000'000);
  CHECK(claim["age_bound_ns"].get<std::int64_t>() < 20'000'000);
  const JudgedRun never = far_from("0");  // nothing is old, and nothing is judged
  CHECK(never.of("claims", "echo")["age_max_ns"].is_null());
}

TEST_CASE("a job that was lost with its release is late, as are those behind it") {
  const JudgedRun ran = run_blind("lost_release", "400ms");
  CHECK(ran.exit_status == 1);
  CHECK(ran.document["overruns"] == 0);
  const Json response = ran.of("responses", "urgent");
  CHECK(response["judged"] == "broken");
  CHECK(response["update_max_ns"].get<std::int64_t>() > 200'000);
}

TEST_CASE("a stage that does not end before the run does is late") {
  const JudgedRun ran = run_blind("hang", "900ms");
  CHECK(ran.exit_status == 1);
  CHECK(ran.document["overruns"] == 0);
  const Json response = ran.of("responses", "logger");
  CHECK(response["judged"] == "broken");
  CHECK(response["update_max_ns"].get<std::int64_t>() == 400'000'000);
  CHECK(ran.of("responses", "urgent")["judged"] == "held");
}

TEST_CASE("a reset that a scenario asks for may come in the middle of a job") {
  const TemporaryFolder folder;
  for (const char* t_ns : {"400060000", "400700000"}) {
    write_file(folder.path("reset.json"), std::string(R"({"schema": "finemote.scenario/1", "events": [{"t_ns": )") +
                                              t_ns + R"(, "do": "reset"}]})");
    const JudgedRun ran =
        run_robot(source_path("examples/infantry.urdf"), "300ms", {"--scenario", folder.path("reset.json")});
    CHECK(ran.document["order"]["mistake"].is_null());
    CHECK(ran.exit_status == 0);
  }
}
