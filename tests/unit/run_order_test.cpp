// What `run` makes of the order in which stages began and ended.
#include "generator/run/order.hpp"

#include <map>

#include "tests/unit/robot_plan.hpp"

namespace finemote::gen {
namespace {

/// A controller over a sensor, and a lamp in a slower bucket.
RobotPlan three_devices() {
  return RobotPlan(R"(<device name="controller" type="sim_load" period="10ms"><device name="sensor" type="sim_load"/>
    </device><device name="lamp" type="sim_load" period="20ms"/>)");
}

/// Stages of a record: `+sensor` begins its update, `-sensor` its handle; a second one ends it. A microsecond each.
RunRecord record_of(const RobotPlan& plan, const std::vector<std::string>& edges) {
  RunRecord record;
  std::map<std::string, bool> is_open;
  for (const std::string& edge : edges) {
    bool& open = is_open[edge];
    record.events.push_back({microseconds(static_cast<std::int64_t>(record.events.size())), plan.device(edge.substr(1)),
                             edge[0] == '-', open});
    open = !open;
  }
  return record;
}

const std::vector<std::string> kJob = {"+sensor",     "+sensor",     "+controller", "+controller",
                                       "-controller", "-controller", "-sensor",     "-sensor"};

OrderVerdict judge(const RobotPlan& plan, const RunRecord& record) {
  return judge_order(*plan.robot, plan.schedule, record);
}

}  // namespace

TEST_CASE("updates from leaf to root and handles back are in order, job after job") {
  const RobotPlan plan = three_devices();
  std::vector<std::string> edges = kJob;
  edges.insert(edges.end(), kJob.begin(), kJob.end());
  const OrderVerdict verdict = judge(plan, record_of(plan, edges));
  CHECK(verdict.is_judged);
  CHECK_FALSE(verdict.mistake);
}

TEST_CASE("a job of another bucket can come in between") {
  const RobotPlan plan = three_devices();
  std::vector<std::string> edges = {"+lamp"};
  edges.insert(edges.end(), kJob.begin(), kJob.end());
  edges.insert(edges.end(), {"+lamp", "-lamp", "-lamp"});
  CHECK_FALSE(judge(plan, record_of(plan, edges)).mistake);
}

TEST_CASE("a stage that comes too early is the mistake, and what was due is named") {
  const RobotPlan plan = three_devices();
  const OrderVerdict verdict = judge(plan, record_of(plan, {"+sensor", "+sensor", "-controller", "-controller"}));
  CHECK(verdict.is_judged);
  REQUIRE(verdict.mistake);
  CHECK(*verdict.mistake == "begin of controller.handle() at 2us, where the begin of controller.update() was due");
}

TEST_CASE("a stage that begins twice is a mistake") {
  const RobotPlan plan = three_devices();
  RunRecord record = record_of(plan, {"+sensor"});
  record.events.push_back({microseconds(1), plan.device("sensor"), false, false});
  const OrderVerdict verdict = judge(plan, record);
  REQUIRE(verdict.mistake);
  CHECK(*verdict.mistake == "begin of sensor.update() at 1us, where the end of sensor.update() was due");
}

TEST_CASE("a job that a reset cut off begins anew") {
  const RobotPlan plan = three_devices();
  RunRecord record = record_of(plan, {"+sensor", "+sensor", "+controller"});
  record.events.push_back({microseconds(3), plan.device("sensor"), false, false});
  CHECK(judge(plan, record).mistake);
  record.resets = 1;
  CHECK_FALSE(judge(plan, record).mistake);
}

TEST_CASE("where no stage ran nothing is judged") {
  const RobotPlan plan = three_devices();
  const OrderVerdict verdict = judge(plan, {});
  CHECK_FALSE(verdict.is_judged);
  CHECK_FALSE(verdict.mistake);
}

}  // namespace finemote::gen
