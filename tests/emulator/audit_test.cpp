// The raw record of a run: what docs/reference/audit.md says, line by line.
#include <map>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "tests/cli/program.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

/// A run with its record, taken apart.
struct Audited {
  Json run, head;
  std::vector<Json> lines;  ///< after the first

  Audited(const std::string& robot, const std::string& duration, const std::vector<std::string>& options = {}) {
    const TemporaryFolder folder;
    std::vector<std::string> words = {"run", robot, "--duration", duration, "--audit", folder.path("audit.jsonl")};
    words.insert(words.end(), options.begin(), options.end());
    run = finemote_json(words);
    std::istringstream text(read_file(folder.path("audit.jsonl")));
    for (std::string line; std::getline(text, line);) {
      Json event = Json::parse(line);
      if (event["what"] == "robot") ++phases;
      (event["what"] == "robot" && head.is_null() ? head : lines.emplace_back()) = std::move(event);
    }
  }

  [[nodiscard]] std::vector<Json> of(const std::string& what) const {
    std::vector<Json> some;
    for (const Json& line : lines) {
      if (line["what"] == what) some.push_back(line);
    }
    return some;
  }

  unsigned phases = 0;
};

const std::string kExpander = source_path("tests/emulator/bounds/bring_up.urdf");
const std::string kSensor = source_path("tests/emulator/bounds/two_frames.urdf");

}  // namespace

TEST_CASE("the first line says what the numbers of the others stand for") {
  const Audited audit(kSensor, "100ms");
  CHECK(audit.head["image"] == audit.run["image"]["sha256"]);
  CHECK(audit.head["phase"] == 0);
  CHECK(audit.head["clock_hz"] == 168e6);
  REQUIRE(!audit.head["stages"].empty());
  REQUIRE(audit.head["stages"].size() == audit.run["stages"].size());
  for (const Json& stage : audit.head["stages"]) {
    INFO(stage.dump());
    CHECK(stage["period_ns"] == 11'000'000);
    CHECK(audit.head["exceptions"][std::to_string(stage["exception"].get<int>())]["kind"] == "bucket");
  }
  CHECK(audit.head["exceptions"]["15"]["kind"] == "release");
  unsigned buses = 0;
  for (const Json& exception : audit.head["exceptions"]) buses += exception["kind"] == "bus" ? 1 : 0;
  CHECK(buses > 0);
}

TEST_CASE("times rise, and every kind of line has its members") {
  const std::map<std::string, std::set<std::string>> members = {{"enter", {"exception"}},
                                                                {"tail", {"exception"}},
                                                                {"return", {"exception"}},
                                                                {"resume", {"exception"}},
                                                                {"due", {"exception"}},
                                                                {"mask", {}},
                                                                {"unmask", {}},
                                                                {"begin", {"stage"}},
                                                                {"end", {"stage"}},
                                                                {"ready", {}},
                                                                {"sample", {"part", "channel", "n", "from"}},
                                                                {"used", {"device", "channel", "n", "claimed"}},
                                                                {"output", {"part", "channel", "device", "job"}},
                                                                {"superseded", {"device", "job", "sent"}}};
  std::set<std::string> seen;
  for (const std::string& robot : {kSensor, kExpander}) {
    const Audited audit(robot, "200ms");
    std::int64_t last = audit.lines.front()["t"];
    bool all_rise = true, all_as_said = true;
    for (const Json& line : audit.lines) {
      std::set<std::string> keys;
      for (const auto& [key, value] : line.items()) keys.insert(key);
      keys.erase("t");
      keys.erase("what");
      const auto kind = members.find(line["what"]);
      all_as_said = all_as_said && kind != members.end() && kind->second == keys;
      all_rise = all_rise && line["t"].get<std::int64_t>() >= last;
      last = line["t"];
      seen.insert(line["what"].get<std::string>());
    }
    CHECK(all_rise);
    CHECK(all_as_said);
    REQUIRE(audit.of("ready").size() == 1);
    CHECK(audit.of("ready")[0]["t"] == audit.run["bringup_ns"].get<std::int64_t>() * 1000);
  }
  for (const auto& [what, keys] : members) {
    INFO(what);
    const bool is_always = what != "superseded" && what != "mask" && what != "unmask";
    CHECK((seen.count(what) == 1 || !is_always));
  }
}

TEST_CASE("begins and ends from the end of the bring-up on are the runs of the stages") {
  const Audited audit(kExpander, "200ms");
  const std::int64_t ready = audit.of("ready")[0]["t"], end = ready + 200'000'000'000;
  std::map<std::size_t, int> begins, ends;
  for (const Json& line : audit.of("begin")) {
    if (line["t"] >= ready && line["t"] < end) ++begins[line["stage"]];
  }
  for (const Json& line : audit.of("end")) ++ends[line["stage"]];
  REQUIRE(!audit.head["stages"].empty());
  for (std::size_t k = 0; k < audit.head["stages"].size(); ++k) {
    const Json& stage = audit.head["stages"][k];
    INFO(stage.dump());
    CHECK(stage["device"] == audit.run["stages"][k]["device"]);
    CHECK(stage["stage"] == audit.run["stages"][k]["stage"]);
    CHECK(audit.run["stages"][k]["count"] == begins[k]);
    CHECK(ends[k] >= begins[k]);
  }
}

TEST_CASE("what was used was a sample that could be read, and the age at the update is the measured one") {
  const Audited audit(kSensor, "300ms");
  std::map<std::uint32_t, Json> samples;
  for (const Json& sample : audit.of("sample")) samples[sample["n"]] = sample;
  const std::vector<Json> uses = audit.of("used");
  CHECK(uses.size() > 20);
  std::int64_t begin = 0, oldest = 0;
  const std::int64_t ready = audit.of("ready")[0]["t"];
  std::map<std::int64_t, std::int64_t> begin_of;  // of an update, by its end
  for (const Json& line : audit.lines) {
    if (line["what"] == "begin" && line["stage"] == 0) begin = line["t"];
    if (line["what"] == "end" && line["stage"] == 0) begin_of[line["t"]] = begin;
  }
  for (const Json& use : uses) {
    INFO(use.dump());
    REQUIRE(samples.count(use["n"]) == 1);
    const Json& sample = samples[use["n"]];
    CHECK(sample["t"].get<std::int64_t>() <= use["t"].get<std::int64_t>());
    CHECK(sample["from"].get<std::int64_t>() <= sample["t"].get<std::int64_t>());
    REQUIRE(begin_of.count(use["t"]) == 1);
    const std::int64_t update = begin_of[use["t"]];
    if (update >= ready) oldest = std::max(oldest, update - sample["from"].get<std::int64_t>());
  }
  const std::int64_t measured = audit.run["chains"][0]["acquire"]["max_ns"];
  CHECK(std::abs(oldest / 1000 - measured) <= 1);
}

TEST_CASE("every handle of an output comes out once, or a later one did") {
  const Audited audit(kExpander, "300ms");
  std::map<std::string, std::vector<std::uint32_t>> outcomes;
  for (const Json& line : audit.lines) {
    const bool is_outcome = line["what"] == "output" || line["what"] == "superseded";
    if (is_outcome && !line["job"].is_null()) outcomes[line["device"]].push_back(line["job"]);
  }
  REQUIRE(outcomes.size() == 3);
  for (const auto& [device, jobs] : outcomes) {
    INFO(device);
    CHECK(jobs.size() > 5);
    for (std::size_t i = 1; i < jobs.size(); ++i) CHECK((jobs[i] == jobs[i - 1] || jobs[i] == jobs[i - 1] + 1));
  }
}

TEST_CASE("overruns are in the record as the firmware counts them") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="base"/><finemote version="1">
      <board name="robomaster_type_c"/>
      <device name="busy" type="sim_load" period="2ms"><param name="update">2500us</param></device>
    </finemote></robot>)");
  const Audited audit(folder.path("r.urdf"), "50ms");
  const std::vector<Json> overruns = audit.of("overrun");
  CHECK(overruns.size() >= 5);
  CHECK(audit.run["overruns"] == overruns.size());
  for (const Json& overrun : overruns) CHECK(overrun["exception"] == audit.head["stages"][0]["exception"]);
}

TEST_CASE("every phase begins with its own first line, and its clock is off by 50 ppm at most") {
  const Audited audit(kSensor, "50ms", {"--phases", "3", "--seed", "7"});
  CHECK(audit.phases == 3);
  CHECK(audit.head["seed"] == 7);
  std::vector<Json> heads = audit.of("robot");
  heads.push_back(audit.head);
  std::set<double> clocks;
  for (const Json& head : heads) {
    CHECK(std::abs(head["clock_hz"].get<double>() / 168e6 - 1) <= 50.001e-6);
    clocks.insert(head["clock_hz"].get<double>());
  }
  CHECK(clocks.size() > 1);
}
