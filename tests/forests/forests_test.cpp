// Random forests generate, compile for the host, and run in the prescribed order. FINEMOTE_FORESTS sets how many.
#include "catch.hpp"
#include "cli/order.hpp"
#include "cli/program.hpp"
#include "forests/prescribed_order.hpp"

#include <cstdlib>
#include <sstream>

using namespace finemote::test;

namespace {

constexpr std::size_t kBatch = 25;  // robots that share one CMake project and one runtime library

std::size_t how_many() {
  const char* text = std::getenv("FINEMOTE_FORESTS");
  return text != nullptr ? static_cast<std::size_t>(std::atol(text)) : 200;
}

/// One project with a firmware per robot; the runtime is compiled once.
std::string project_text(const std::vector<RandomForest>& forests) {
  std::string text =
      "cmake_minimum_required(VERSION 3.25)\nproject(forests LANGUAGES CXX)\n"
      "include(" +
      source_path("cmake/FinemoteFirmware.cmake") + ")\n";
  for (const RandomForest& forest : forests) {
    text += "finemote_add_firmware(" + forest.name + " GENERATED ${CMAKE_CURRENT_SOURCE_DIR}/" + forest.name +
            " BOARD host)\n";
    text += "set_target_properties(" + forest.name + " PROPERTIES UNITY_BUILD ON)\n";  // one compiler call for each
  }
  return text;
}

/// The jobs of each bucket as the firmware's own trace shows them: the stages between two releases, in order.
std::map<int, std::vector<std::string>> observed_stages(const RandomForest& forest, const nlohmann::json& tree,
                                                        const std::string& record) {
  std::vector<std::string> names;  // by stage number / 2
  for (const auto& t : tree["trees"]) {
    for (const auto& device : t["devices"]) names.push_back(device["name"]);
  }
  std::map<std::string, int> period;
  for (const RandomDevice& device : forest.devices) period[device.name] = device.period_ms;
  std::map<int, std::vector<std::string>> stages;
  std::istringstream lines(record);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("E ", 0) != 0 || line.back() != 'B') continue;
    std::istringstream words(line.substr(2));
    long at = 0;
    std::size_t stage = 0;
    words >> at >> stage;
    const std::string& name = names.at(stage / 2);
    stages[period.at(name)].push_back((stage % 2 == 0 ? "+" : "-") + name);
  }
  return stages;
}

/// The stages of a bucket are its job, again and again.
void check_order(const RandomForest& forest, const nlohmann::json& tree, const std::string& record) {
  const auto jobs = prescribed_order(forest);
  const auto stages = observed_stages(forest, tree, record);
  CHECK(stages.size() == jobs.size());
  for (const auto& [period, seen] : stages) {
    const std::vector<std::string>& job = jobs.at(period);
    REQUIRE(seen.size() >= 2 * job.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      INFO("stage " << i << " of the " << period << " ms bucket");
      REQUIRE(seen[i] == job[i % job.size()]);
    }
  }
}

}  // namespace

TEST_CASE("random forests generate, compile and run in the prescribed order") {
  const std::size_t count = how_many();
  for (std::size_t first = 1; first <= count; first += kBatch) {
    TemporaryFolder folder;
    std::vector<RandomForest> forests;
    std::vector<nlohmann::json> trees;
    for (std::size_t seed = first; seed < first + kBatch && seed <= count; ++seed) {
      const RandomForest forest = random_forest(seed);
      INFO(to_urdf(forest));
      write_file(folder.path(forest.name + ".urdf"), to_urdf(forest));
      const auto generated = run_finemote(
          {"generate", folder.path(forest.name + ".urdf"), "-o", folder.path(forest.name), "--allow-unschedulable"});
      INFO(generated.output);
      REQUIRE(generated.exit_status == 0);
      trees.push_back(finemote_json({"tree", folder.path(forest.name + ".urdf")}));
      forests.push_back(forest);
    }
    write_file(folder.path("CMakeLists.txt"), project_text(forests));
    const std::chrono::seconds limit(900);
    const std::string build = folder.path("build");
    const std::vector<std::string> configure{"cmake", "-S", folder.path(), "-B",
                                             build,   "-G", "Ninja",       "-DCMAKE_CXX_FLAGS=-O0 -g0"};
    REQUIRE(finemote::gen::run_process(configure, limit).exit_status == 0);
    const auto built = finemote::gen::run_process({"cmake", "--build", build}, limit);
    INFO(built.output);
    REQUIRE(built.exit_status == 0);
    for (std::size_t i = 0; i < forests.size(); ++i) {
      INFO(to_urdf(forests[i]));
      const auto run = finemote::gen::run_process({build + "/" + forests[i].name, "90000000"}, limit);
      REQUIRE(run.exit_status == 0);
      check_order(forests[i], trees[i], run.output);
    }
  }
}
