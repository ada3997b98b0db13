// finemote check: tells stale, hand-edited, missing, orphan and line-endings apart.
#include "catch.hpp"
#include "cli/program.hpp"

#include <filesystem>

using namespace finemote::test;
namespace fs = std::filesystem;

namespace {

/// A generated example to spoil.
struct Generated {
  Generated() {
    write_file(robot, read_file(source_path("examples/deep_forest.urdf")));
    REQUIRE(run_finemote({"generate", robot, "-o", out}).exit_status == 0);
  }
  nlohmann::json check() const { return finemote_json({"check", robot, "-o", out}); }

  TemporaryFolder folder;
  std::string robot = folder.path("robot.urdf");
  std::string out = folder.path("out");
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void check_one_finding(const nlohmann::json& result, const std::string& state, const std::string& file) {
  CHECK(result["fresh"] == false);
  REQUIRE(result["findings"].size() == 1);
  CHECK(result["findings"][0]["state"] == state);
  CHECK(result["findings"][0]["file"] == file);
}

}  // namespace

TEST_CASE("what was just generated is fresh") {
  const Generated generated;
  const auto result = run_finemote({"check", generated.robot, "-o", generated.out});
  CHECK(result.exit_status == 0);
  CHECK(result.output.find("fresh\n") != std::string::npos);
}

TEST_CASE("an edited file is hand-edited, and --diff shows the edit undone") {
  const Generated generated;
  const std::string file = generated.out + "/trees/walker.cpp";
  write_file(file, replaced(read_file(file), "walker.update();", "walker.update();  // mine"));
  check_one_finding(generated.check(), "hand-edited", "trees/walker.cpp");
  const auto result = run_finemote({"check", generated.robot, "-o", generated.out, "--diff"});
  CHECK(result.exit_status == 1);
  CHECK(result.output.find("--- a/trees/walker.cpp") != std::string::npos);
  CHECK(result.output.find("// mine") != std::string::npos);
}

TEST_CASE("a deleted file is missing") {
  const Generated generated;
  fs::remove(generated.out + "/buses.cpp");
  check_one_finding(generated.check(), "missing", "buses.cpp");
}

TEST_CASE("CR line ends alone are line-endings") {
  const Generated generated;
  std::string text;
  for (const char c : read_file(generated.out + "/schedule.hpp"))
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  write_file(generated.out + "/schedule.hpp", text);
  check_one_finding(generated.check(), "line-endings", "schedule.hpp");
}

TEST_CASE("a generated file nobody lists is an orphan; a user's file is not") {
  const Generated generated;
  write_file(generated.out + "/trees/old.cpp", read_file(generated.out + "/trees/walker.cpp"));
  write_file(generated.out + "/notes.txt", "mine");
  check_one_finding(generated.check(), "orphan", "trees/old.cpp");
}

TEST_CASE("a changed period makes files stale, and the reason names the input") {
  const Generated generated;
  write_file(generated.robot, replaced(read_file(generated.robot), "period=\"2ms\"", "period=\"1ms\""));
  const auto result = run_finemote({"check", generated.robot, "-o", generated.out});
  CHECK(result.exit_status == 1);
  CHECK(result.output.find("stale        schedule.cpp: 'robot.urdf' changed") != std::string::npos);
}

TEST_CASE("white space in the robot's file leaves the output fresh") {
  const Generated generated;
  write_file(generated.robot, replaced(read_file(generated.robot), "<finemote version", "\n\n  <finemote version"));
  CHECK(generated.check()["fresh"] == true);
}

TEST_CASE("another version of the tool with the same bytes is fresh, with a note") {
  const Generated generated;
  const std::string manifest = generated.out + "/finemote.manifest.json";
  write_file(manifest, replaced(read_file(manifest), "\"tool\": \"finemote ", "\"tool\": \"finemote 0.0."));
  const auto result = run_finemote({"check", generated.robot, "-o", generated.out});
  CHECK(result.exit_status == 0);
  CHECK(result.output.find("tool-changed") != std::string::npos);
}

TEST_CASE("a manifest that cannot be used is a warning, and the answer is no") {
  const Generated generated;
  write_file(generated.out + "/finemote.manifest.json", "{}");
  const auto result = run_finemote({"check", generated.robot, "-o", generated.out});
  CHECK(result.exit_status == 1);
  CHECK(result.output.find("FM5001") != std::string::npos);
}

TEST_CASE("every example keeps what it requires of itself") {
  std::size_t robots = 0;
  for (const auto& entry : fs::directory_iterator(source_path("examples"))) {
    if (entry.path().extension() != ".urdf") continue;
    INFO(entry.path());
    const auto result = run_finemote({"analyze", entry.path().string()});
    CHECK(result.exit_status == 0);
    ++robots;
  }
  CHECK(robots >= 6);
}
