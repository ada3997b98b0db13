// How much execution times may grow: the largest factor is schedulable, and the next one is not.
#include "generator/timing/slack.hpp"

#include "catch.hpp"
#include "generator/timing/profile.hpp"
#include "timing_robots.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

Model robot_of(Duration period, Duration update, Duration handle) {
  Model model;
  timing::Device device;
  device.name = "d";
  device.period = period;
  device.update_wcet = update;
  device.handle_wcet = handle;
  model.devices.push_back(device);
  return model;
}

bool is_schedulable(Model model, Profile profile, std::int64_t permille) {
  for (timing::Device& device : model.devices) {
    device.update_wcet = ceil_div(device.update_wcet * permille, 1000);
    device.handle_wcet = ceil_div(device.handle_wcet * permille, 1000);
  }
  return analyse_deadlines(model, profile).result.schedulable;
}

}  // namespace

TEST_CASE("slack of one device is its period by its work, up to a factor of 1000") {
  CHECK(slack_permille(robot_of(milliseconds(10), microseconds(10), microseconds(4)), Profile::tight) == 714'285);
  CHECK(slack_permille(robot_of(milliseconds(10), microseconds(6), microseconds(4)), Profile::tight) == kMostSlack);
  CHECK(slack_permille(robot_of(milliseconds(10), microseconds(6), microseconds(5)), Profile::tight) == 909'090);
  CHECK(slack_permille(robot_of(milliseconds(10), microseconds(6), nanoseconds(1)), Profile::tight) == kMostSlack);
  CHECK(slack_permille(robot_of(milliseconds(10), milliseconds(9), milliseconds(2)), Profile::tight) == 909);
}

TEST_CASE("slack and verdict of a robot never disagree") {
  for (const char* name : {"examples/finsrov.urdf", "examples/infantry.urdf", "examples/two_devices.urdf"}) {
    const Robots robot(name);
    CAPTURE(name);
    const std::int64_t slack = slack_permille(robot.model, Profile::target);
    CHECK(is_schedulable(robot.model, Profile::target, slack));
    if (slack < kMostSlack) CHECK_FALSE(is_schedulable(robot.model, Profile::target, slack + 1));
  }
}
