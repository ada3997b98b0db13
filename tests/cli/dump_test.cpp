// --dump: every stage of the pipeline as one JSON document, and nothing else.
#include <cstdlib>
#include <filesystem>

#include "catch.hpp"
#include "cli/program.hpp"
#include "tests/rewrites.hpp"

using namespace finemote::test;

namespace {

nlohmann::json dump(const std::string& command, const std::string& robot, const std::string& stage) {
  const auto result = run_finemote({command, source_path(robot), "--dump", stage});
  INFO(result.output);
  REQUIRE(result.exit_status == 0);
  return nlohmann::json::parse(result.output);
}

}  // namespace

TEST_CASE("the stages of a small robot are those that were reviewed") {
  const auto stage = GENERATE("document", "model", "forest", "schedule", "tasks", "plan");
  INFO(stage);
  const std::string golden = source_path("tests/golden/stages/" + std::string(stage) + ".json");
  const auto result = run_finemote({"generate", source_path("examples/two_devices.urdf"), "--dump", stage});
  REQUIRE(result.exit_status == 0);
  if (finemote::test::rewrites()) write_file(golden, result.output);
  CHECK(result.output == read_file(golden));
}

TEST_CASE("every command shows the same stages") {
  const auto stage = GENERATE("document", "model", "forest", "schedule", "tasks", "plan");
  const std::string robot = "examples/infantry.urdf";
  const auto shown = dump("generate", robot, stage);
  for (const char* command : {"check", "analyze", "simulate", "run"}) {
    INFO(command << " --dump " << stage);
    CHECK(dump(command, robot, stage) == shown);
  }
}

TEST_CASE("what a stage shows is what comes of it") {
  const std::string robot = "examples/finsrov.urdf.xacro";
  const std::string text = dump("generate", robot, "document")["text"];
  CHECK(text.find("name=\"thruster_8\"") != std::string::npos);
  CHECK(text.find("xacro:") == std::string::npos);
  const auto model = dump("generate", robot, "model");
  REQUIRE(model["devices"].size() == 14);
  CHECK(model["devices"][0]["name"] == "rov");
  CHECK(model["devices"][0]["children"].size() == 13);
  CHECK(model["source"] == "finsrov.urdf.xacro");
  const auto order = dump("generate", robot, "forest")["order"];
  CHECK(order.front() == "imu");
  CHECK(order.back() == "rov");
  const auto buckets = dump("generate", robot, "schedule")["buckets"];
  CHECK(buckets[0]["devices"] == nlohmann::ordered_json{"imu"});  // the shortest period comes first
  CHECK(buckets[1]["devices"].size() == 13);
  CHECK(buckets[1]["devices"].back() == "rov");
  const auto analysis = finemote_json({"analyze", source_path(robot)});
  CHECK(dump("analyze", robot, "tasks")["model"] == analysis["model"]);
  const auto files = dump("generate", robot, "plan")["files"];
  CHECK(files[0]["file"] == "schedule.hpp");
  CHECK(files[0]["template"] == "schedule.hpp.mustache");
  CHECK(files[0]["values"]["robot"] == "FinsROV");
}

TEST_CASE("a stage is shown whatever the robot's deadlines, and nothing is written") {
  const TemporaryFolder folder;
  const auto result = run_finemote(
      {"generate", source_path("examples/two_devices.urdf"), "-o", folder.path("out"), "--dump", "schedule"});
  CHECK(result.exit_status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("out")));
}

TEST_CASE("a timing model has one stage") {
  const std::string model = "tests/analysis-cases/finsrov.json";
  CHECK(dump("analyze", model, "tasks")["model"]["devices"].size() == 14);
  CHECK(dump("simulate", model, "tasks")["model"]["devices"].size() == 14);
  const auto refused = run_finemote({"analyze", source_path(model), "--dump", "forest"});
  CHECK(refused.exit_status == 2);
  CHECK(refused.output.find("is a timing model, which has no stage 'forest'") != std::string::npos);
}

TEST_CASE("a stage that does not exist, and a robot with errors, are no answer") {
  const auto unknown = run_finemote({"generate", source_path("examples/two_devices.urdf"), "--dump", "forrest"});
  CHECK(unknown.exit_status == 2);
  CHECK(unknown.output.find("did you mean 'forest'?") != std::string::npos);
  const TemporaryFolder folder;
  write_file(folder.path("wrong.urdf"), "<robot name=\"r\"><finemote version=\"1\"/></robot>");
  CHECK(run_finemote({"generate", folder.path("wrong.urdf"), "--dump", "model"}).exit_status == 2);
  CHECK(run_finemote({"generate", folder.path("wrong.urdf"), "--dump", "document"}).exit_status == 0);
}
