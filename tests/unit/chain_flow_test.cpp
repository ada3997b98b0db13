// From what a record shows to the updates that the data of a command came from.
#include "generator/run/measure.hpp"
#include "generator/run/printed_record.hpp"
#include "robot_plan.hpp"

using namespace finemote::gen;

namespace {

/// Two devices in each of seven layers, which both read both of the layer before: 128 ways from the first to the last.
std::string diamonds() {
  std::string text = R"(<device name="source" type="sim_load" period="1ms"/>)";
  for (int layer = 1; layer <= 7; ++layer) {
    const std::string number = std::to_string(layer), before = std::to_string(layer - 1);
    for (const char* side : {"a", "b"}) {
      text += "<device name=\"" + (side + number) + "\" type=\"group\" period=\"1ms\">";
      const std::vector<std::string> read =
          layer == 1 ? std::vector<std::string>{"source"} : std::vector<std::string>{"a" + before, "b" + before};
      for (const std::string& device : read) text += "<reads device=\"" + device + "\" role=\"children\"/>";
      text += "</device>";
    }
  }
  return text + R"(<device name="sink" type="group" period="1ms"><reads device="a7" role="children"/>
    <reads device="b7" role="children"/></device>)";
}

void run(RunRecord& record, DeviceId device, bool is_handle, Duration begin) {
  record.events.push_back({begin, device, is_handle, false});
  record.events.push_back({begin + nanoseconds(100), device, is_handle, true});
}

}  // namespace

TEST_CASE("of many ways the one with the oldest data counts, wherever it is") {
  const RobotPlan plan(diamonds());
  RunRecord record;
  // The source runs twice. Only the b of one layer at a time saw the first run alone: it ran before the second one.
  const int late = GENERATE(1, 4, 7);
  run(record, plan.device("source"), false, microseconds(0));
  Duration at = microseconds(1);
  for (int round = 0; round < 2; ++round) {
    for (int layer = 1; layer <= 7; ++layer) {
      for (const char* side : {"a", "b"}) {
        if (round == 1 && layer == late && side == std::string("b")) continue;
        run(record, plan.device(side + std::to_string(layer)), false, at += microseconds(1));
      }
    }
    if (round == 0) run(record, plan.device("source"), false, at += microseconds(1));
  }
  run(record, plan.device("sink"), false, at += microseconds(1));
  run(record, plan.device("sink"), true, at += microseconds(1));
  const StageRuns runs(record, plan.robot->devices.size());
  const auto samples =
      decision_samples(record, runs, find_chain(*plan.robot, plan.device("source"), plan.device("sink")));
  REQUIRE(samples.size() == 1);
  CHECK(samples.front().update.begin == microseconds(0));
  CHECK(samples.front().handle_end == at + nanoseconds(100));
}

TEST_CASE("no data of a device reach another: no chain") {
  const RobotPlan plan(R"(<device name="one" type="sim_load" period="1ms"/>
    <device name="other" type="sim_load" period="1ms"/>)");
  CHECK_FALSE(find_chain(*plan.robot, plan.device("one"), plan.device("other")));
  CHECK(find_chain(*plan.robot, plan.device("one"), plan.device("one")));
}

TEST_CASE("a printed record with a bus that the robot lacks is refused") {
  const Forest none;
  CHECK(parse_record("B 1 5 0 100\n", none, 2, seconds(1)));
  CHECK_FALSE(parse_record("B 99 0 0\n", none, 2, seconds(1)));
  CHECK(parse_record("a user's line\n", none, 0, seconds(1)));
}
