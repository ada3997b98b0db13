// What runs when: buckets, what crosses between them, and the slots of their transfers.
#include "generator/schedule/schedule.hpp"

#include <map>
#include <set>

#include "catch.hpp"
#include "unit/robot_plan.hpp"

using namespace finemote::gen;

namespace {

/// A device of no hardware that combines its children; `inner` is what stands in it.
std::string load(const std::string& name, const std::string& period, const std::string& inner = {}) {
  return "<device name=\"" + name + "\" type=\"sim_load\" period=\"" + period + "\">" + inner + "</device>\n";
}
std::string reads(const std::string& device) { return "<reads device=\"" + device + "\" role=\"children\"/>"; }

/// `1ms: a b; 10ms: c`
std::string buckets(const RobotPlan& planned) {
  std::string text;
  for (const Bucket& bucket : planned.schedule.buckets)
    text += (text.empty() ? "" : "; ") + bucket.label + ": " + planned.names(bucket.devices);
  return text;
}

/// `state a_to_b: to_slow` per line.
std::string crossings(const RobotPlan& planned) {
  const std::map<Crossing::Kind, std::string> kinds{
      {Crossing::Kind::to_slow, "to_slow"}, {Crossing::Kind::to_fast, "to_fast"}, {Crossing::Kind::copy, "copy"}};
  std::string text;
  for (const Crossing& crossing : planned.schedule.crossings) {
    text += crossing.direction == Crossing::Direction::state ? "state " : "command ";
    text += crossing.name + ": " + kinds.at(crossing.kind) + "\n";
  }
  return text;
}

/// What the first role of a device is bound to, in order.
const std::vector<Binding>& bindings(const RobotPlan& planned, const std::string& name) {
  return planned.schedule.roles[planned.device(name)].front().bindings;
}

std::string slots(const RobotPlan& planned) {
  std::string text;
  for (const Slot& slot : planned.schedule.slots)
    text += (text.empty() ? "" : " ") + slot.name + "@" + std::to_string(slot.priority);
  return text;
}

const std::string kPwm =
    "<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/>"
    "<expander name=\"pwm\" model=\"pca9685\" bus=\"i2c\" address=\"0x40\"/>";
std::string esc(const std::string& name, const std::string& period, int channel) {
  return "<device name=\"" + name + "\" type=\"pwm_esc\" bus=\"pwm\" channel=\"" + std::to_string(channel) +
         "\" period=\"" + period + "\"/>\n";
}

}  // namespace

TEST_CASE("devices of one period share a bucket, the shortest period comes first, and leaves come before roots") {
  const RobotPlan planned(load("slow", "10ms", load("a", "10ms") + load("quick", "1ms")) + load("other", "1ms"));
  CHECK(buckets(planned) == "1ms: quick other; 10ms: a slow");
}

TEST_CASE("the shorter the period, the more urgent the level, on lines in the order of the board") {
  const RobotPlan planned(load("a", "20ms") + load("b", "1ms") + load("c", "5ms"));
  const Board& board = *planned.robot->board;
  REQUIRE(planned.schedule.buckets.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(planned.schedule.buckets[i].priority == board.first_bucket_level + i);
    CHECK(planned.schedule.buckets[i].line == board.lines[i].number);
  }
}

TEST_CASE("more periods than the board has levels and lines are an error at the first that has none") {
  std::string inner;
  for (int n = 1; n <= 17; ++n) inner += load("d" + std::to_string(n), std::to_string(n) + "ms");
  const RobotPlan planned(inner);
  CHECK(planned.said().find("error[FM3201]: 17 different periods") != std::string::npos);
}

TEST_CASE("within one tree and one bucket, values are read where they are") {
  const RobotPlan planned(load("root", "10ms", load("leaf", "10ms")));
  CHECK(crossings(planned).empty());
  const Binding& leaf = bindings(planned, "root").front();
  CHECK_FALSE(leaf.state_crossing);
  CHECK_FALSE(leaf.command_crossing);
}

TEST_CASE("between buckets, states and commands go through latches, named by who preempts whom") {
  const RobotPlan slow_parent(load("root", "10ms", load("leaf", "1ms")));
  CHECK(crossings(slow_parent) == "state leaf_to_root: to_slow\ncommand root_to_leaf: to_fast\n");
  const RobotPlan fast_parent(load("root", "1ms", load("leaf", "10ms")));
  CHECK(crossings(fast_parent) == "state leaf_to_root: to_fast\ncommand root_to_leaf: to_slow\n");
}

TEST_CASE("between trees of one bucket, the state is copied; a command to what is only read goes nowhere") {
  const RobotPlan planned(load("a", "10ms") + load("b", "10ms", reads("a")));
  CHECK(crossings(planned) == "state a_to_b: copy\n");
  const Binding& binding = bindings(planned, "b").front();
  CHECK(planned.name(binding.device) == "a");
  CHECK(binding.is_read);
  CHECK(binding.sink);
  CHECK(binding.sink_name == "b_children_sink_0");
  CHECK_FALSE(binding.command_crossing);
}

TEST_CASE("children are bound before what is read, each in document order") {
  const RobotPlan planned(load("x", "10ms") + load("root", "10ms", reads("x") + load("b", "10ms") + load("a", "10ms")));
  std::string bound;
  for (const Binding& binding : bindings(planned, "root")) bound += planned.name(binding.device) + " ";
  CHECK(bound == "b a x ");
}

TEST_CASE("a generated name that a device has is an error") {
  const RobotPlan planned(load("root", "10ms", load("leaf", "1ms") + load("leaf_to_root", "10ms")));
  CHECK(planned.said().find("error[FM3202]: the generated name 'leaf_to_root' for device 'root' is already taken") !=
        std::string::npos);
  CHECK(planned.said().find("note: device 'leaf_to_root' has it") != std::string::npos);
}

TEST_CASE("slots stand most urgent first, and an expander is as urgent as the fastest of its users") {
  const RobotPlan planned(kPwm + esc("late", "20ms", 0) + esc("early", "5ms", 1) +
                          "<device name=\"baro\" type=\"ms5837\" bus=\"i2c\" period=\"10ms\"/>\n");
  INFO(planned.said());
  CHECK(slots(planned) == "pwm@0 baro@1");
}

TEST_CASE("a multiplexer has no slot of its own") {
  const RobotPlan planned(
      "<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\"/>"
      "<expander name=\"mux\" model=\"tca9548a\" bus=\"i2c\" address=\"0x70\"><channel index=\"0\" name=\"c0\"/>"
      "<channel index=\"1\" name=\"c1\"/></expander>"
      "<device name=\"b1\" type=\"ms5837\" bus=\"c1\" period=\"20ms\"/>"
      "<device name=\"b0\" type=\"ms5837\" bus=\"c0\" period=\"10ms\"/>\n");
  CHECK(slots(planned) == "b0@0 b1@1");
}

TEST_CASE("each bucket that drives an expander flushes it once") {
  const RobotPlan planned(kPwm + esc("a", "5ms", 0) + esc("b", "5ms", 1) + esc("c", "20ms", 2) + load("d", "1ms"));
  REQUIRE(planned.schedule.buckets.size() == 3);
  CHECK(planned.schedule.buckets[0].flushes.empty());
  CHECK(planned.schedule.buckets[1].flushes.size() == 1);
  CHECK(planned.schedule.buckets[1].flushes == planned.schedule.buckets[2].flushes);
}

TEST_CASE("every example keeps the rules of the plan") {
  const auto file = GENERATE("finsrov.urdf", "infantry.urdf", "six_joint_arm.urdf", "deep_forest.urdf",
                             "two_devices.urdf", "user_device.urdf");
  INFO(file);
  const RobotPlan planned(RobotFile{std::string("examples/") + file});
  const Robot& robot = *planned.robot;
  const Schedule& schedule = planned.schedule;
  std::size_t scheduled = 0;
  for (const Bucket& bucket : schedule.buckets) {
    scheduled += bucket.devices.size();
    for (const auto& device : bucket.devices) {
      CHECK(robot.devices[device].period == bucket.period);
      CHECK(&schedule.buckets[schedule.bucket_of[device]] == &bucket);
    }
  }
  CHECK(scheduled == robot.devices.size());
  for (const Crossing& crossing : schedule.crossings) {
    INFO(crossing.name);
    const Duration from = robot.devices[crossing.producer].period;
    const Duration to = robot.devices[crossing.consumer].period;
    CHECK((crossing.kind == Crossing::Kind::to_slow) == (from < to));
    CHECK((crossing.kind == Crossing::Kind::to_fast) == (from > to));
  }
  std::set<std::string> names;
  for (const Slot& slot : schedule.slots) {
    INFO(slot.name);
    CHECK(names.insert(slot.name).second);
    CHECK(slot.device.has_value() != slot.expander.has_value());
  }
}
