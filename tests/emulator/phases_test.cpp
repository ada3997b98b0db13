// Runs that are repeated with random phases and clock errors.
#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/figures.hpp"

using namespace finemote::test;

namespace {

nlohmann::json run_phases(const std::string& phases, const std::string& seed) {
  return finemote_json({"run", source_path("tests/emulator/bounds/two_frames.urdf"), "--duration", "200ms", "--phases",
                        phases, "--seed", seed});
}

}  // namespace

TEST_CASE("the same seed gives the same document, another one other figures") {
  const auto first = run_phases("3", "7");
  CHECK(first["phases"] == 3);
  CHECK(first["seed"] == 7);
  CHECK(first == run_phases("3", "7"));
  const auto other = run_phases("3", "8");
  REQUIRE(first["chains"].size() >= 1);
  CHECK(first["chains"][0]["acquire"] != other["chains"][0]["acquire"]);
}

TEST_CASE("the figures of several phases are those of all runs") {
  const auto one = run_phases("1", "7"), three = run_phases("3", "7");
  REQUIRE(!one["chains"].empty());
  REQUIRE(one["chains"].size() == three["chains"].size());
  for (std::size_t i = 0; i < one["chains"].size(); ++i) {
    const auto &few = one["chains"][i]["acquire"], &many = three["chains"][i]["acquire"];
    INFO(many.dump());
    CHECK(few["max_ns"].get<std::int64_t>() <= many["max_ns"].get<std::int64_t>());
    CHECK(few["min_ns"].get<std::int64_t>() >= many["min_ns"].get<std::int64_t>());
    CHECK(three["chains"][i]["samples"] > 2 * one["chains"][i]["samples"].get<int>());
  }
}

TEST_CASE("bytes are counted once, also where an interrupt counts them while a job does") {
  const auto document = finemote_json({"run", source_path("tests/emulator/bounds/two_frames.urdf"), "--duration", "1s",
                                       "--phases", "8", "--seed", "4"});
  CHECK(document["faults"] == false);
  check_own_times(document);
}

TEST_CASE("a board without parts plays no phases and keeps no record") {
  const TemporaryFolder folder;
  const std::string robot = source_path("examples/two_devices.urdf");
  const std::vector<std::vector<std::string>> refused = {
      {"--phases", "3"}, {"--audit", folder.path("audit.jsonl")}, {"--silicon", "strict"}, {"--slowest"}};
  for (const auto& options : refused) {
    std::vector<std::string> words = {"run", robot, "--board", "host"};
    words.insert(words.end(), options.begin(), options.end());
    const auto ran = run_finemote(words);
    INFO(ran.output);
    CHECK(ran.exit_status == 2);
    CHECK(ran.output.find("error[FM6011]: '" + options.front() + "' needs the emulated board") != std::string::npos);
  }
  CHECK(files_below(folder.path()).empty());
}
