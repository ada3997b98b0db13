// `run --silicon`: robots hold their bounds on chips that use the freedom their manual leaves, too.
#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/figures.hpp"

using namespace finemote::test;

TEST_CASE("every example is as good on a chip that is strict in every way as on a plain one") {
  for (const std::string& robot : example_robots()) {
    INFO(robot);
    const auto ran = run_finemote(
        {"run", source_path("examples/" + robot), "--duration", "150ms", "--silicon", "strict", "--format", "json"});
    INFO(ran.output);
    CHECK(ran.exit_status == 0);
    const auto begin = ran.output.find('{');
    REQUIRE(begin != std::string::npos);
    const auto document = nlohmann::json::parse(ran.output.substr(begin));
    CHECK(document["silicon"]["names"].size() == 13);
    CHECK(document["silicon"]["seed"] == 1);
    CHECK(document["fault_counts"].empty());
    CHECK(document["resets"] == 0);
    CHECK(ran.output.find("FM6005") == std::string::npos);
  }
}

TEST_CASE("the slowest mode misses every line of flash on a chip that is strict in every way") {
  const auto run = [](const std::vector<std::string>& mode) {
    std::vector<std::string> words = {"run", source_path("examples/deep_forest.urdf"), "--duration", "60ms"};
    words.insert(words.end(), mode.begin(), mode.end());
    return finemote_json(words);
  };
  const auto slowest = run({"--slowest"});
  CHECK(slowest["flash"] == "miss");
  CHECK(slowest["silicon"]["names"].size() == 13);
  CHECK(slowest["stages"] == run({"--flash", "miss", "--silicon", "strict"})["stages"]);
  CHECK(run({"--slowest", "--silicon", "strict:spi_busy"})["silicon"]["names"].size() == 1);
}

TEST_CASE("names choose in what the chip is strict, and seeds how much") {
  const auto run = [](const std::string& silicon, const std::string& seed) {
    return finemote_json(
        {"run", source_path("examples/two_devices.urdf"), "--duration", "100ms", "--silicon", silicon, "--seed", seed});
  };
  const auto first = run("strict:spi_busy,dma_store", "3");
  CHECK(first["silicon"] == nlohmann::json::parse(R"({"names": ["dma_store", "spi_busy"], "seed": 3})"));
  CHECK(first == run("strict:dma_store,spi_busy", "3"));
  const auto plain = finemote_json({"run", source_path("examples/two_devices.urdf"), "--duration", "100ms"});
  CHECK(plain["silicon"]["names"].empty());
}

TEST_CASE("clocks are as far off as board and parts allow, and times are still compared at their nominal rate") {
  const auto clock_hz = [](const std::string& silicon, const std::string& seed) {
    const TemporaryFolder folder;
    const std::string audit = folder.path("audit.jsonl");
    const auto document = finemote_json({"run", source_path("examples/infantry.urdf"), "--duration", "100ms",
                                         "--silicon", silicon, "--seed", seed, "--audit", audit});
    check_own_times(document);
    const std::string record = read_file(audit);
    return nlohmann::json::parse(record.substr(0, record.find('\n')))["clock_hz"].get<double>();
  };
  CHECK(clock_hz("strict:spi_busy", "1") == 168e6);
  const double first = clock_hz("strict:clock_rates", "1"), second = clock_hz("strict:clock_rates", "2");
  CHECK(first != second);
  CHECK(first == Approx(168e6).epsilon(51e-6));
}

TEST_CASE("what is no chip is said") {
  const auto refused = [](const std::string& silicon, const std::string& message) {
    const auto ran = run_finemote({"run", source_path("examples/two_devices.urdf"), "--silicon", silicon});
    INFO(ran.output);
    CHECK(ran.exit_status == 2);
    CHECK(ran.output.find(message) != std::string::npos);
  };
  refused("mean", "there is no silicon 'mean'");
  refused("strict:dma_stor", "no chip is 'dma_stor'");
  refused("strict:dma_stor", "did you mean 'dma_store'");
}
