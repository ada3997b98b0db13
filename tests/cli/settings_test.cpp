// finemote.json beside a robot: what it sets, what goes before it, and that it is an input.
#include "catch.hpp"
#include "cli/program.hpp"

using namespace finemote::test;

namespace {

/// A xacro robot whose period is an argument, with settings beside it.
struct Project {
  explicit Project(const std::string& settings) {
    write_file(robot, R"x(<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="period" default="10ms"/><link name="base_link"/>
  <finemote version="1"><board name="robomaster_type_c"/>
    <device name="load" type="sim_load" period="$(arg period)"><wcet update="9us" handle="9us"/></device>
  </finemote></robot>)x");
    write_file(folder.path("finemote.json"), settings);
  }
  [[nodiscard]] nlohmann::json settings(std::vector<std::string> words = {}) const {
    words.insert(words.begin(), {"analyze", robot, "--show-config"});
    return finemote_json(words).at("settings");
  }

  TemporaryFolder folder;
  std::string robot = folder.path("robot.urdf.xacro");
  std::string out = folder.path("out");
};

nlohmann::json setting(const nlohmann::json& settings, const std::string& name) {
  for (const auto& entry : settings) {
    if (entry.at("name") == name) return {entry.at("value"), entry.at("from")};
  }
  return nullptr;
}

}  // namespace

TEST_CASE("a setting counts where the command line says nothing") {
  const Project project(R"({ "arguments": { "period": "20ms", "unused": "1" },
  "board": "host", "profile": "tight", "deny": ["FM3151"] })");
  const std::string file = project.folder.path("finemote.json");
  const auto settings = project.settings({"--profile", "paper", "unused:=2"});
  CHECK(setting(settings, "board") == nlohmann::json{"host", file + ":2"});
  CHECK(setting(settings, "profile") == nlohmann::json{"paper", "command line"});
  CHECK(setting(settings, "arguments.period") == nlohmann::json{"20ms", file + ":1"});
  CHECK(setting(settings, "arguments.unused") == nlohmann::json{"2", "command line"});
  CHECK(setting(settings, "deny") == nlohmann::json{"FM3151", file + ":2"});
  CHECK(setting(settings, "chain") == nlohmann::json{"", "default"});
  CHECK(run_finemote({"tree", project.robot}).output.find("20 ms") != std::string::npos);
  CHECK(run_finemote({"tree", project.robot, "period:=40ms"}).output.find("40 ms") != std::string::npos);
}

TEST_CASE("settings are an input: of the manifest, of the depfile, and of check") {
  const Project project(R"({ "arguments": { "period": "20ms" } })");
  const std::string rule = project.folder.path("rule.d");
  REQUIRE(run_finemote({"generate", project.robot, "-o", project.out, "--depfile", rule}).exit_status == 0);
  CHECK(read_file(rule).find("finemote.json") != std::string::npos);
  const std::string manifest = read_file(project.out + "/finemote.manifest.json");
  CHECK(manifest.find("\"finemote.json\"") != std::string::npos);
  CHECK(manifest.find("period:=20ms") != std::string::npos);
  CHECK(run_finemote({"check", project.robot, "-o", project.out}).exit_status == 0);
  write_file(project.folder.path("finemote.json"), R"({ "arguments": { "period": "40ms" } })");
  const auto stale = run_finemote({"check", project.robot, "-o", project.out});
  CHECK(stale.exit_status == 1);
  CHECK(stale.output.find("'finemote.json' changed") != std::string::npos);
}

TEST_CASE("each side of diff has its own settings, and init takes them along") {
  const Project slow(R"({ "arguments": { "period": "20ms" } })"), fast(R"({ "arguments": { "period": "5ms" } })");
  const auto diff = run_finemote({"diff", slow.robot, fast.robot});
  CHECK(diff.output.find("device 'load': period 20 ms -> 5 ms\n") == 0);
  const std::string project = slow.folder.path("project");
  REQUIRE(run_finemote({"init", project, "--from", fast.robot}).exit_status == 0);
  CHECK(read_file(project + "/src/finemote.json") == read_file(fast.folder.path("finemote.json")));
  CHECK(run_finemote({"check", project + "/src/robot.urdf.xacro", "-o", project + "/generated"}).exit_status == 0);
}

TEST_CASE("folders of settings are those beside them, wherever the command runs") {
  const Project project(R"({ "device-path": ["more"] })");
  write_file(project.folder.path("more/lamp.json"), "{}");
  std::string robot = read_file(project.robot);
  write_file(project.robot, robot.replace(robot.find("sim_load"), 8, "lamp"));
  CHECK(run_finemote({"tree", project.robot}).output.find("more/lamp.json:1:1: error[FM3104]") != std::string::npos);
  const auto elsewhere = run_finemote({"tree", project.robot, "--device-path", project.folder.path()});
  CHECK(elsewhere.output.find("error[FM3021]") != std::string::npos);
}
