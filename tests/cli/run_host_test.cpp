// finemote run on the host board: the observed order is the schedule.
#include "catch.hpp"
#include "cli/order.hpp"
#include "cli/program.hpp"

using namespace finemote::test;

TEST_CASE("every example runs on the host in the order of its schedule") {
  for (const std::string& robot : example_robots()) {
    INFO(robot);
    const std::string input = source_path("examples/" + robot);
    const auto tree = finemote_json({"tree", input});
    const auto run = finemote_json({"run", input, "--board", "host"});
    CHECK(run["schema"] == "finemote.run/1");
    CHECK(run["overruns"] == 0);
    CHECK(order_mistake(tree, run) == "");
    CHECK(count_jobs(tree, run) >= 2 * tree["buckets"].size());
  }
}

TEST_CASE("a fast bucket preempts a slow one") {
  const auto run = finemote_json({"run", source_path("examples/deep_forest.urdf"), "--board", "host"});
  TemporaryFolder folder;
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="l"/><finemote version="1"><board name="host"/>
    <device name="slow" type="sim_load" period="10ms"><param name="update">3ms</param></device>
    <device name="fast" type="sim_load" period="1ms"><param name="update">100us</param></device></finemote></robot>)");
  const auto tree = finemote_json({"tree", folder.path("r.urdf")});
  const auto loaded = finemote_json({"run", folder.path("r.urdf")});
  CHECK(shows_preemption(loaded));
  CHECK(order_mistake(tree, loaded) == "");
}

TEST_CASE("a run that overruns says so with exit status 1") {
  TemporaryFolder folder;
  write_file(folder.path("r.urdf"), R"(<robot name="r"><link name="l"/><finemote version="1"><board name="host"/>
    <device name="a" type="sim_load" period="1ms"><param name="update">1500us</param></device></finemote></robot>)");
  const auto result = run_finemote({"run", folder.path("r.urdf"), "--json", folder.path("run.json")});
  CHECK(result.exit_status == 1);
  CHECK(result.output.find("overruns") != std::string::npos);
  const auto document = nlohmann::json::parse(read_file(folder.path("run.json")));
  CHECK(document["schema"] == "finemote.run/1");
  CHECK(document["overruns"] > 0);
  CHECK(document.contains("diagnostics"));
}

TEST_CASE("the document of a run never takes the place of the robot") {
  TemporaryFolder folder;
  const std::string robot = R"(<robot name="r"><link name="l"/><finemote version="1"><board name="host"/>
    <device name="a" type="sim_load" period="1ms"/></finemote></robot>)";
  write_file(folder.path("r.urdf"), robot);
  const auto result =
      run_finemote({"run", folder.path("r.urdf"), "--keep", folder.path("kept"), "--json", folder.path("r.urdf")});
  CHECK(result.exit_status == 2);
  CHECK(result.output.find("--json") != std::string::npos);
  CHECK(read_file(folder.path("r.urdf")) == robot);
  CHECK(files_below(folder.path("kept")).empty());
}
