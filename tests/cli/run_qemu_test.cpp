// finemote run in QEMU: compiled for the Cortex-M4, the observed order is the schedule, and twice the same.
#include "catch.hpp"
#include "cli/order.hpp"
#include "cli/program.hpp"

using namespace finemote::test;

TEST_CASE("every example runs in QEMU in the order of its schedule") {
  for (const std::string& robot : example_robots()) {
    INFO(robot);
    const std::string input = source_path("examples/" + robot);
    const auto tree = finemote_json({"tree", input});
    const auto run = finemote_json({"run", input, "--board", "qemu_f405"});
    CHECK(run["overruns"] == 0);
    CHECK(order_mistake(tree, run) == "");
    CHECK(count_jobs(tree, run) >= 2 * tree["buckets"].size());
  }
}

TEST_CASE("two runs in QEMU are the same to the last byte") {
  const std::string input = source_path("examples/deep_forest.urdf");
  const auto first = run_finemote({"run", input, "--board", "qemu_f405", "--format", "json"});
  const auto second = run_finemote({"run", input, "--board", "qemu_f405", "--format", "json"});
  CHECK(first.exit_status == 0);
  CHECK(first.output == second.output);
}
