// No device claims its data fresher than they are: time stamps of the firmware beside the samples that the states are
// made of, which are found without them.
#include <algorithm>
#include <map>
#include <sstream>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

constexpr std::int64_t kPsPerUs = 1'000'000;

/// Of each device the largest difference between what it claimed and when that sample was taken, after the bring-up.
std::map<std::string, std::int64_t> leads_in(const std::string& audit) {
  std::map<std::string, std::int64_t> leads;
  std::map<std::tuple<std::string, unsigned, unsigned>, std::int64_t> taken;
  std::vector<Json> uses;
  std::int64_t ready = 0;
  const auto judge = [&] {
    for (const Json& use : uses) {
      if (use["claimed"].is_null() || use["t"] < ready) continue;
      const std::int64_t lead =
          use["claimed"].get<std::int64_t>() - taken.at({use["device"], use["channel"], use["n"]});
      const auto [entry, is_first] = leads.try_emplace(use["device"], lead);
      entry->second = std::max(entry->second, lead);
    }
    uses.clear();
    taken.clear();
  };
  std::istringstream text(audit);
  for (std::string line; std::getline(text, line);) {
    const Json event = Json::parse(line);
    const std::string what = event["what"];
    if (what == "robot") judge();
    if (what == "ready") ready = event["t"];
    if (what == "used") uses.push_back(event);
    if (what == "sample") taken[{event["part"], event["channel"], event["n"]}] = event["from"];
  }
  judge();
  return leads;
}

/// Leads of a robot's devices, which `run` tells as they are.
std::map<std::string, std::int64_t> leads_of(const std::string& robot) {
  const TemporaryFolder folder;
  const Json run = finemote_json({"run", source_path(robot), "--duration", "200ms", "--phases", "3", "--seed", "8",
                                  "--audit", folder.path("audit.jsonl")});
  const auto leads = leads_in(read_file(folder.path("audit.jsonl")));
  REQUIRE(!run["claims"].empty());
  for (const Json& claim : run["claims"]) {
    INFO(claim.dump());
    CHECK(claim["judged"] == (claim["lead_max_ns"].is_null() ? "no-sample" : "held"));
    if (claim["lead_max_ns"].is_null()) continue;
    const double ns = static_cast<double>(leads.at(claim["device"])) / 1e3;
    CHECK(claim["lead_max_ns"].get<double>() == Approx(ns).epsilon(1e-4).margin(2));
  }
  return leads;
}

}  // namespace

TEST_CASE("frames of motors that wait for each other, for commands and for late routines") {
  for (const char* robot :
       {"examples/infantry.urdf", "examples/six_joint_arm.urdf", "tests/emulator/robots/crane.urdf"}) {
    INFO(robot);
    const auto leads = leads_of(robot);
    REQUIRE(leads.size() >= 6);
    for (const auto& [device, lead] : leads) {
      INFO(device);
      CHECK(lead <= kPsPerUs);
    }
  }
}

TEST_CASE("registers that are old when they are read, conversions and receivers") {
  for (const char* robot :
       {"tests/emulator/robots/rig.urdf", "tests/emulator/robots/rover.urdf", "examples/finsrov.urdf"}) {
    INFO(robot);
    const auto leads = leads_of(robot);
    REQUIRE(leads.size() >= 4);
    for (const auto& [device, lead] : leads) {
      INFO(device);
      CHECK(lead <= kPsPerUs);
      CHECK(lead > -7000 * kPsPerUs);  // nor much older: the slowest of these parts measures every 5 ms
    }
  }
}

TEST_CASE("what comes while the time of the firmware has not begun is long ago") {
  const Json run = finemote_json({"run", source_path("tests/emulator/bounds/late_first_release.urdf"), "--duration",
                                  "12ms", "--phases", "400", "--seed", "3"});
  CHECK(run["claims"].at(0)["judged"] == "held");
}

TEST_CASE("all frames that came since the last look are taken, and the last of them counts") {
  const Json run = finemote_json(
      {"run", source_path("tests/emulator/bounds/slow_reader.urdf"), "--duration", "600ms", "--phases", "2"});
  CHECK(run["claims"].at(0)["judged"] == "held");
}

TEST_CASE("data of a serial line look as old as such data can, whatever their part says on another bus") {
  const Json run = finemote_json({"run", source_path("tests/emulator/bounds/talking_imu.urdf"), "--duration", "300ms",
                                  "--phases", "4", "--seed", "3"});
  const Json& claim = run["claims"].at(0);
  CHECK(claim["judged"] == "held");
  CHECK(claim["age_max_ns"] > 4'000'000);  // above what it would be held to as data of the CAN bus
}
