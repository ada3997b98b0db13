// How old data can look by their time stamps, and what the firmware dates frames on CAN by.
#include "unit/duration_literals.hpp"
#include "unit/timing_robots.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

namespace {

/// `count` motors on one CAN bus, each of which sends a thousand frames in a second.
Robots motors(int count, const std::string& period = "1ms") {
  std::string devices;
  for (int id = 1; id <= count; ++id) {
    devices += R"(<device name="m)" + std::to_string(id) + R"(" type="dji_m3508" bus="can" id=")" + std::to_string(id) +
               R"("/>)";
  }
  return Robots::with(R"(<bus name="can" type="can" port="can1"/><device name="chassis" type="group" period=")" +
                      period + "\">" + devices + "</device>");
}

Timing timing_of(const Robots& robot) {
  Diagnostics diagnostics;
  AnalysisRequest request;
  request.inputs = request.every = true;
  auto timing = analyse(robot.model, request, diagnostics);
  REQUIRE(timing);
  return *timing;
}

Duration acquire_of(const Timing& timing, Rank from) {
  for (const auto* chains : {&timing.chains, &timing.others}) {
    for (const ChainResult& c : *chains) {
      if (c.from == from) return *c.acquire;
    }
  }
  FAIL("no chain begins there");
  return {};
}

std::optional<Duration> wait_of(const Robots& robot, const std::string& device) {
  return timing_of(robot).frame_waits[robot[device]];
}

}  // namespace

TEST_CASE("a frame on CAN waits for all others at most, and the firmware may date it by as much too early") {
  const Robots robot = motors(4);
  const auto wait = wait_of(robot, "m4");
  REQUIRE(wait);
  // Five frames of 135 bits, by a clock that may be a hundredth off; ours may be there twice, as its job varies by a
  // period.
  CHECK(*wait > 5 * 135_us);
  CHECK(*wait < 7 * 135_us);
  const Timing timing = timing_of(robot);
  const Rank m4 = robot["m4"];
  const Duration acquire = acquire_of(timing, m4);
  REQUIRE(timing.stamped_ages[m4]);
  CHECK(*timing.stamped_ages[m4] > acquire + *wait);
  CHECK(*timing.stamped_ages[m4] < acquire + *wait + 100_us);
}

TEST_CASE("what frames are dated by does not depend on execution times") {
  Robots robot = motors(4);
  const auto wait = wait_of(robot, "m2");
  REQUIRE(wait);
  for (const Rank d : robot.model.devices.ids()) robot.model.devices[d].update_wcet += 70_us;
  CHECK(wait_of(robot, "m2") == wait);
}

TEST_CASE("where late jobs could delay a frame for any time, it is dated by its interval") {
  const Robots robot = motors(5, "2ms");
  const auto wait = wait_of(robot, "m4");
  REQUIRE(wait);
  CHECK(*wait > 980_us);
  CHECK(*wait < 1_ms);
  CHECK(timing_of(robot).stamped_ages[robot["m4"]]);
}

TEST_CASE("an answer that a device asks for on CAN is dated by no more than the time to the next one") {
  Robots robot = motors(2, "5ms");
  const Rank m1 = robot["m1"];
  timing::Device& device = robot.model.devices[m1];
  device.acquisition->periods = 1;
  for (Transfer& transfer : device.transfers) {
    if (transfer.after != Transfer::After::autonomous) continue;
    transfer.after = Transfer::After::update;
    transfer.reads = true;
    transfer.min_interval = {};
  }
  const Timing timing = timing_of(robot);
  REQUIRE(timing.frame_waits[m1]);
  CHECK(*timing.frame_waits[m1] > 2 * 135_us);
  CHECK(*timing.frame_waits[m1] <= device.period);
  REQUIRE(timing.stamped_ages[m1]);
  CHECK(*timing.stamped_ages[m1] > acquire_of(timing, m1) + *timing.frame_waits[m1]);
}

TEST_CASE("an edge is dated by the row of interrupts in which it was served") {
  const Robots robot("tests/emulator/bounds/edges.urdf");
  const Timing timing = timing_of(robot);
  std::size_t edges = 0;
  for (const Rank d : robot.model.devices.ids()) {
    if (!robot.model.devices[d].acquisition || !robot.model.devices[d].transfers.empty()) continue;
    ++edges;
    CHECK(*timing.stamped_ages[d] >= acquire_of(timing, d) + robot.model.costs.event_entry);
  }
  CHECK(edges > 0);
}

TEST_CASE("a frame that is read before the silence behind it is dated by two bytes") {
  const Robots robot = Robots::with(
      R"(<bus name="line" type="uart" port="usart6" baud="460800baud"/><bus name="pwm" type="pwm" port="pwm1"/>
         <device name="link" type="host_link" bus="line" period="10ms">
         <device name="esc" type="pwm_esc" bus="pwm" channel="0"/></device>)");
  const Timing timing = timing_of(robot);
  const Rank link = robot["link"];
  CHECK(*timing.stamped_ages[link] > acquire_of(timing, link) + floor_div(2 * 10 * 1_s, 460'800));
}

TEST_CASE("frames that may wait for as long as their part's interval have no bound, nor has the look of their data") {
  const Robots robot = motors(8);
  CHECK_FALSE(wait_of(robot, "m1"));
  const Timing timing = timing_of(robot);
  CHECK_FALSE(timing.stamped_ages[robot["m1"]]);
}

TEST_CASE("commands look older than their data are, by as much as stamps may be too early") {
  const Robots robot = Robots::with(
      R"(<bus name="line" type="uart" port="usart1" baud="921600baud"/><bus name="pwm" type="pwm" port="pwm1"/>
         <device name="rov" type="group" period="10ms"><device name="imu" type="h30_imu" bus="line"/>
         <device name="esc" type="pwm_esc" bus="pwm" channel="0"/></device>)");
  const Timing timing = timing_of(robot);
  REQUIRE(timing.inputs.size() == timing.stamped_inputs.size());
  for (std::size_t i = 0; i < timing.inputs.size(); ++i) {
    const ChainResult &truth = timing.inputs[i], &stamped = timing.stamped_inputs[i];
    CHECK(stamped.from == truth.from);
    CHECK(*stamped.age > *truth.age);
    CHECK(*stamped.age - *truth.age == *stamped.acquire - *truth.acquire);
    CHECK(stamped.acquire == timing.stamped_ages[stamped.from]);
  }
}
