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
  CHECK(result.output.find("stale        schedule.cpp\n") != std::string::npos);
  CHECK(result.output.find("\nbecause 'robot.urdf' changed\nrun: ") != std::string::npos);
  const auto document = generated.check();
  CHECK(document["findings"].size() > 1);
  for (const auto& finding : document["findings"]) CHECK(finding["reason"] == "'robot.urdf' changed");
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

TEST_CASE("where bytes differ, the reason names the version that wrote the folder") {
  const Generated generated;
  const std::string manifest = generated.out + "/finemote.manifest.json";
  write_file(manifest, replaced(read_file(manifest), "\"tool\": \"finemote ", "\"tool\": \"finemote 0.0."));
  write_file(generated.robot, replaced(read_file(generated.robot), "period=\"2ms\"", "period=\"1ms\""));
  const auto result = run_finemote({"check", generated.robot, "-o", generated.out});
  CHECK(result.exit_status == 1);
  CHECK(result.output.find("'robot.urdf' changed; written by finemote 0.0.0.1.0, checked with finemote 0.1.0\n") !=
        std::string::npos);
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

TEST_CASE(
    "diff names what changes an answer alone: requirements, sources of execution times, masses, places of joints") {
  const TemporaryFolder folder;
  const std::string device = R"(<device name="gimbal" type="gimbal" period="2ms">)";
  std::string before = read_file(source_path("examples/infantry.urdf"));
  REQUIRE(before.find(device) != std::string::npos);
  before.insert(before.find(device) + device.size(), R"(<wcet update="2us" handle="9us"/>)");
  const auto said = [&](const std::string& old, const std::string& now) {
    std::string after = before;
    REQUIRE(after.find(old) != std::string::npos);
    after.replace(after.find(old), old.size(), now);
    write_file(folder.path("a.urdf"), before);
    write_file(folder.path("b.urdf"), after);
    const auto result = run_finemote({"diff", folder.path("a.urdf"), folder.path("b.urdf")});
    CHECK(result.exit_status == 1);
    return result.output.substr(0, result.output.find('\n'));
  };
  const std::size_t at = before.find("<require ");
  REQUIRE(at != std::string::npos);
  const std::string requirement = before.substr(at, before.find("/>", at) + 2 - at);
  CHECK(said(requirement, "").find(": removed") != std::string::npos);
  CHECK(said(requirement, requirement + "\n<require utilization=\"dbus\" max=\"99%\"/>") ==
        "requirement utilization 'dbus': added");
  const std::string max = requirement.substr(requirement.find("max="));
  CHECK(said(max, "max=\"1us\"/>").find(": max ") != std::string::npos);
  CHECK(said("<wcet ", "<wcet source=\"static\" ").find(": source of the wcet budget -> static") != std::string::npos);
  CHECK(said("<mass value=\"11.5\"/>", "<mass value=\"12\"/>") == "link 'base_link': mass 11.5 -> 12");
  CHECK(said("xyz=\"0.2 0.2 -0.05\"", "xyz=\"0.2 0.2 -0.06\"")
            .find("joint 'wheel_front_left_joint': origin xyz 0.2 0.2 -0.05 -> 0.2 0.2 -0.06") == 0);
}

TEST_CASE("a suggested order makes what analyze shows shorter") {
  for (const char* robot : {"examples/infantry.urdf", "examples/deep_forest.urdf"}) {
    const auto asked = run_finemote({"analyze", source_path(robot), "--suggest-order"});
    const std::size_t table = asked.output.find("suggested order");
    if (table == std::string::npos) {
      CHECK(asked.output.find("no better order of siblings and roots was found") != std::string::npos);
    } else {
      CHECK(asked.output.find("\n  chain ", table) != std::string::npos);  // with the chains that change
    }
  }
  const TemporaryFolder folder;  // without a timing file: with it there is a better order
  write_file(folder.path("arm.urdf"), read_file(source_path("examples/six_joint_arm.urdf")));
  const auto arm = finemote_json({"analyze", folder.path("arm.urdf"), "--suggest-order"});
  std::vector<std::string> order = arm.at("suggested_order"), devices;
  for (const auto& device : arm.at("model").at("devices")) devices.push_back(device.at("name"));
  CHECK(order == devices);  // an order that makes no bound shorter is none to suggest
}

TEST_CASE("simulate answers no where analyze does") {
  const TemporaryFolder folder;
  write_file(folder.path("r.urdf"), R"(<robot name="r"><finemote version="1"><board name="robomaster_type_c"/>
    <device name="a" type="sim_load" period="1ms"><wcet update="300us" handle="300us"/></device>
    <device name="b" type="sim_load" period="2ms"><wcet update="400us" handle="410us"/></device>
    </finemote></robot>)");
  const auto analysed = run_finemote({"analyze", folder.path("r.urdf")});
  const auto simulated = run_finemote({"simulate", folder.path("r.urdf"), "--duration", "1us"});
  INFO(simulated.output);
  CHECK(analysed.exit_status == 1);
  CHECK(simulated.output.find("error[FM4015]") != std::string::npos);
  CHECK(simulated.exit_status == 1);
}

TEST_CASE("a relative --package is a folder of the working directory") {
  const TemporaryFolder folder;
  write_file(folder.path("ws/parts/inc/part.xacro"), R"(<robot><link name="part"/></robot>)");
  write_file(folder.path("ws/my_robot/urdf/r.urdf.xacro"),
             R"(<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
    <xacro:include filename="$(find parts)/inc/part.xacro"/></robot>)");
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder.path("ws"));
  const auto result = run_finemote({"xacro", "my_robot/urdf/r.urdf.xacro", "--package", "parts=parts"});
  std::filesystem::current_path(here);
  INFO(result.output);
  CHECK(result.exit_status == 0);
  CHECK(result.output.find("<link name=\"part\"/>") != std::string::npos);
}
