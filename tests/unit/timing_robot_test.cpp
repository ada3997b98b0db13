// The timing of the example robots, from their URDF.
#include <map>
#include <sstream>
#include <utility>

#include "catch.hpp"
#include "generator/model/part_clock.hpp"
#include "generator/model/streamed_frames.hpp"
#include "generator/simulate/beside_bounds.hpp"
#include "generator/timing/table.hpp"
#include "generator/timing/task_set.hpp"
#include "generator/units/clock_tolerance.hpp"
#include "unit/duration_literals.hpp"
#include "unit/timing_robots.hpp"

using namespace finemote::gen;
using namespace finemote::gen::timing;

TEST_CASE("finsrov is schedulable with the costs of the board, and keeps its requirements") {
  Robots finsrov("examples/finsrov.urdf");
  REQUIRE(finsrov.model.devices.size() == 14);
  CHECK(finsrov.model.devices[Rank{0}].name == "imu");
  CHECK(finsrov.model.devices.back().name == "rov");
  CHECK(finsrov.model.buses.size() == 3);
  AnalysisRequest request;
  request.requirements = timing_requirements(*finsrov.robot, finsrov.forest);
  REQUIRE(request.requirements.size() == 2);
  request.chains = {{Rank{0}, Rank{5}}};
  Diagnostics diagnostics;
  const auto timing = analyse(finsrov.model, request, diagnostics);
  INFO(render_text(diagnostics, false));
  REQUIRE(timing);
  INFO(timing_table(*timing));
  CHECK(timing->asked == Profile::target);
  CHECK(timing->schedulable);
  CHECK(timing->requirements_hold());
  CHECK(timing->chains.size() ==
        16);  // by default the worst sensor of each thruster; the requirement's eight, one of them asked for as well

  // Costs come on top of the work alone, whatever the interrupts do.
  for (const Rank d : finsrov.model.devices.ids()) {
    CHECK(timing->target->devices[d].b_minus > timing->tight.devices[d].b_minus);
    CHECK(*timing->target->devices[d].r_minus > timing->target->devices[d].b_minus);
  }
  // The sensor with the oldest data is asked for its pressure; the attitude comes by itself.
  const ChainResult& attitude = chain(*timing, "imu", "thruster_1");
  CHECK(*attitude.acquire >= 5_ms + 1_ms + floor_div(67 * 10 * 1_s, 921'600));
  CHECK(*attitude.wire >= 33 * 9 * 2'500_ns);  // the burst to eight channels
  CHECK(*attitude.end_to_end == *attitude.acquire + *attitude.decide + *attitude.wire);
}

TEST_CASE("finsrov simulates below its bounds") {
  Robots finsrov("examples/finsrov.urdf");
  SimulationRequest request;
  request.duration = 2_s;
  std::ostringstream trace;
  Diagnostics diagnostics;
  const auto simulated = simulate_beside_bounds(finsrov.model, request, diagnostics, &trace);
  INFO(render_text(diagnostics, false));
  REQUIRE(simulated);
  CHECK(simulated->good());
  const auto events = nlohmann::json::parse(trace.str());
  CHECK(events["traceEvents"].size() > 1000);
}

TEST_CASE("tracing costs time") {
  Robots plain("examples/finsrov.urdf"), traced("examples/finsrov.urdf", {true, false, {}});
  CHECK(traced.model.costs.stage > plain.model.costs.stage);
}

TEST_CASE("an expander driven from two buckets may send a command with a later flush") {
  Robots finsrov("examples/finsrov.urdf");
  const auto wire_of = [](const timing::Model& model) {
    AnalysisRequest request;
    request.chains = {{Rank{0}, Rank{5}}};
    Diagnostics diagnostics;
    const auto timing = analyse(model, request, diagnostics);
    REQUIRE(timing);
    REQUIRE(timing->target->devices[Rank{5}].r_minus);
    return chain(*timing, model.devices[Rank{0}].name, model.devices[Rank{5}].name).wire;
  };
  timing::Model model = finsrov.model;
  REQUIRE(model.flushes.size() == 1);
  REQUIRE(model.flushes[0].output == "pwm");
  model.flushes[0].wire = 100_us;
  model.flushes[0].interrupts = 1;
  const auto alone = wire_of(model);
  REQUIRE(alone);
  Flush fast = model.flushes[0];
  fast.period = 5_ms;
  fast.devices = {Rank{0}};
  model.flushes.push_back(fast);
  const auto shared = wire_of(model);
  REQUIRE(shared);
  CHECK(*shared > 5_ms + model.flushes[0].wire);         // T of the fastest; its urgency is higher than alone
  CHECK(*shared < 2 * *alone + 3 * 1_ms + 5_ms + 1_ms);  // and not much more
  model.flushes.back().output = "another";
  const auto apart = wire_of(model);
  REQUIRE(apart);
  CHECK(*apart < *shared);
}

TEST_CASE("a bus with a clock interrupts when something sits on it, and only then") {
  const Robots rig("tests/emulator/robots/rig.urdf"), idle("tests/unit/idle_buses.urdf");
  for (const timing::Bus& bus : rig.model.buses) {
    INFO(bus.name);
    REQUIRE(bus.sources);
    CHECK_FALSE(bus.sources->empty());
  }
  REQUIRE(idle.model.buses.size() == 3);
  for (const timing::Bus& bus : idle.model.buses) {
    INFO(bus.name);
    REQUIRE(bus.sources);
    CHECK(bus.sources->empty() == (bus.name != "line"));  // anybody may send on a serial line
  }
  Diagnostics findings;
  const auto timing = analyse(idle.model, {}, findings);
  REQUIRE(timing);
  CHECK(timing->schedulable);
}

TEST_CASE("a device with an interrupt line of its own takes no interrupts from those behind it") {
  const std::string bus = R"(<bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>)";
  const std::string load =
      R"(<device name="slow" type="sim_load" period="100ms"><param name="update">20ms</param></device>)";
  const std::string ranger =
      R"(<device name="range" type="ranger" period="5ms" bus="i2c"><use role="ready" pin="key"/></device>)";
  const std::string depth = R"(<device name="depth" type="ms5837" period="20ms" bus="i2c"/>)";
  const auto bound_of_slow = [](const Robots& robot) {
    Diagnostics findings;
    const auto timing = analyse(robot.model, {}, findings);
    REQUIRE(timing);
    return timing->target->devices[robot["slow"]].r_plus;
  };
  const Robots before = Robots::with(bus + ranger + depth + load), behind = Robots::with(bus + depth + ranger + load);
  for (const Robots* robot : {&before, &behind}) {
    const auto& sources = *robot->model.buses[BusPlace{0}].sources;
    REQUIRE(sources.size() == 4);
    for (std::size_t i = 0; i < 3; ++i) CHECK(sources[i].budgets.size() == 2);  // of the driver: transfers of both
    CHECK(sources[3].budgets.empty());                                          // the line
  }
  REQUIRE(bound_of_slow(before));
  CHECK(bound_of_slow(before) == bound_of_slow(behind));
}

TEST_CASE("parts are as slow and as fast as their clocks and the board's allow") {
  const Robots robot = Robots::with(R"(<bus name="line" type="uart" port="usart3" baud="100kbit/s"/>
      <device name="remote" type="dr16" bus="line" period="20ms"/>)");
  const timing::Device& remote = robot.model.devices[robot["remote"]];
  CHECK(robot.model.clock_ppm == 50);
  REQUIRE(remote.acquisition);
  CHECK(remote.acquisition->interval == longest_time(longest_time(14_ms, 10'000), 50));
  REQUIRE(remote.transfers.size() == 1);
  const Transfer& frame = remote.transfers.front();
  CHECK(frame.min_interval == shortest_time(shortest_time(14_ms, 10'000), 50));
  CHECK(frame.wire == longest_time(longest_time(18 * 110_us, 10'000), 50));
  const auto& sources = *robot.model.buses[BusPlace{0}].sources;
  REQUIRE(sources.front().name == "rx_idle");
  CHECK(sources.front().min_interval == shortest_time(shortest_time(100_us, 10'000), 50));
  // Of the line events that the driver allows from one look to the next: frames that two periods hold.
  REQUIRE(sources.front().budgets.size() == 1);
  CHECK(sources.front().budgets.front().count == 3);
  CHECK(sources.front().budgets.front().carry_in == 2);
}

TEST_CASE("commands that go over a bus of a use take their time there, and answers come in") {
  const Robots robot = Robots::with(R"(<bus name="line" type="uart" port="usart1" baud="9600baud"/>
      <device name="talker" type="talker" period="100ms"><use role="line" bus="line"/></device>)");
  Diagnostics findings;
  const auto timing = analyse(robot.model, {}, findings);
  REQUIRE(timing);
  const auto wire = chain(*timing, "talker", "talker").wire;
  CHECK((!wire || *wire >= floor_div(64 * 10 * 1_s, 9600)));
  CHECK(received_bytes(*robot.robot, BusId{0}) == 300);
  CHECK(line_events(*robot.robot, BusId{0}) == 3);
}

TEST_CASE("a flush that a faster one of its expander interrupts may fill its burst again") {
  const auto flushes = [](const std::string& second) {
    const Robots robot = Robots::with(R"(<bus name="i2c" type="i2c" port="i2c2"/>
      <expander name="pulses" model="pca9685" bus="i2c" address="0x40"/>
      <device name="a" type="pwm_servo" bus="pulses" channel="0" period="5ms"/>
      <device name="b" type="pwm_servo" bus="pulses" channel="3" period=")" +
                                      second + "\"/>");
    std::vector<Duration> times;
    for (const Flush& flush : robot.model.flushes) times.push_back(flush.wcet);
    return times;
  };
  const std::vector<Duration> one = flushes("5ms"), two = flushes("10ms");
  REQUIRE((one.size() == 1 && two.size() == 2));
  CHECK(two[0] == one[0]);
  CHECK(two[1] > 2 * one[0] - 4_us);  // the burst thrice, the rest of a flush once
  CHECK(two[1] < 3 * one[0]);
}

TEST_CASE("samples come as often as a param says where the type leaves it to one") {
  const auto link = [](const std::string& param) {
    const Robots robot = Robots::with(R"(<bus name="line" type="uart" port="usart1" baud="921600baud"/>
        <device name="pilot" type="host_link" bus="line" period="10ms">)" +
                                      param + "</device>");
    return robot.model.devices[robot["pilot"]];
  };
  const timing::Device usual = link(""), rare = link(R"(<param name="command_interval">50ms</param>)");
  CHECK(usual.acquisition->interval == longest_time(longest_time(20_ms, 100'000), 50));
  CHECK(rare.acquisition->interval == longest_time(longest_time(50_ms, 100'000), 50));
  const auto stream = std::find_if(rare.transfers.begin(), rare.transfers.end(),
                                   [](const Transfer& t) { return t.after == Transfer::After::autonomous; });
  REQUIRE(stream != rare.transfers.end());
  CHECK(stream->min_interval == shortest_time(shortest_time(50_ms, 100'000), 50));
}

TEST_CASE("a flush on CAN sends the frames of its own bucket, and asks for them once") {
  const Robots robot = Robots::with(R"(<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
      <device name="a" type="dji_m3508" period="2ms" bus="can" id="1"/>
      <device name="b" type="dji_m3508" period="5ms" bus="can" id="5"/>
      <device name="c" type="dji_gm6020" period="5ms" bus="can" id="5"/>)");
  REQUIRE(robot.model.flushes.size() == 2);
  CHECK(robot.model.flushes[0].identifiers == std::vector<std::int64_t>{0x200});
  CHECK(robot.model.flushes[1].identifiers == std::vector<std::int64_t>{0x1FF, 0x2FE});
  for (const Flush& flush : robot.model.flushes) CHECK(flush.interrupts == 0);  // three frames, three mailboxes
  const auto& sources = *robot.model.buses[BusPlace{0}].sources;
  REQUIRE(sources.size() == 3);
  REQUIRE(sources[1].name == "tx");
  REQUIRE(sources[2].name == "request");
  const auto counts = [](const InterruptSource& source) {
    std::vector<std::int64_t> list;
    for (const FrameBudget& budget : source.budgets) list.push_back(budget.count);
    return list;
  };
  CHECK(counts(sources[1]) == std::vector<std::int64_t>{1, 2});
  CHECK(counts(sources[2]) == std::vector<std::int64_t>{1, 1});
}

TEST_CASE("identifiers decide nothing on CAN where a device does not say what it sends") {
  const Robots robot = Robots::with(R"(<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
      <device name="a" type="dji_m3508" period="2ms" bus="can" id="1"/>
      <device name="b" type="silent_on_can" period="2ms" bus="can" id="9"/>)");
  REQUIRE(robot.model.flushes.size() == 1);
  CHECK(robot.model.flushes[0].identifiers.empty());
  CHECK(robot.model.flushes[0].interrupts > 0);
}

TEST_CASE("nothing has a bound over a bus where a device does not say what it sends") {
  const auto with = [](const std::string& more) {
    Robots robot = Robots::with(R"(<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
        <bus name="other" type="can" port="can2" bitrate="1Mbit/s"/>
        <device name="motor" type="dji_m3508" period="2ms" bus="can" id="1"/>
        <device name="far" type="dji_m3508" period="2ms" bus="other" id="1"/>)" +
                                more);
    Diagnostics findings;
    auto timing = analyse(robot.model, {}, findings);
    REQUIRE(timing);
    return std::move(*timing);
  };
  const Timing declared = with(R"(<device name="asker" type="asker" period="2ms" bus="can" id="9"/>)");
  CHECK(chain(declared, "motor", "motor").end_to_end);
  CHECK(chain(declared, "asker", "asker").acquire);
  const Timing timing = with(R"(<device name="quiet" type="silent_on_can" period="2ms" bus="can" id="9"/>)");
  CHECK(timing.schedulable);
  CHECK(!chain(timing, "motor", "motor").acquire);
  CHECK(chain(timing, "motor", "motor").decide);
  CHECK(!chain(timing, "motor", "motor").wire);
  CHECK(!chain(timing, "quiet", "quiet").acquire);
  CHECK(chain(timing, "far", "far").end_to_end);
  REQUIRE(timing.missing.size() == 2);
  for (const MissingBound& missing : timing.missing) {
    CHECK(missing.why == "the load of bus 'can' is unknown: 'quiet' does not declare what it sends there ('frames')");
    CHECK(missing.restored_by.empty());
  }
}

TEST_CASE("what leaves has no bound where a device does not say what it sends, on whatever bus") {
  Robots robot = Robots::with(R"(<bus name="line" type="rs485" port="usart1" baud="115200baud"/>
        <device name="node" type="mute_on_rs485" period="10ms" bus="line" id="3"/>)");
  Diagnostics findings;
  const auto timing = analyse(robot.model, {}, findings);
  REQUIRE(timing);
  CHECK(chain(*timing, "node", "node").decide);
  CHECK(!chain(*timing, "node", "node").wire);
}

TEST_CASE("software asks for transfers at any distance") {
  const Robots robot = Robots::with(R"(<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
      <device name="a" type="dji_m3508" period="2ms" bus="can" id="1"/>)");
  const auto& sources = *robot.model.buses[BusPlace{0}].sources;
  REQUIRE(sources[2].name == "request");
  CHECK(sources[2].min_interval == 1_ns);
}

TEST_CASE("where the timer cannot count to the next release it interrupts in between") {
  const auto with_period = [](const std::string& period) {
    return Robots::with("<device name=\"a\" type=\"sim_load\" period=\"" + period + "\"/>").model;
  };
  CHECK(with_period("99ms").costs.longest_release == 0_ns);
  const Model slow = with_period("200ms"), slower = with_period("800ms");
  CHECK(slow.costs.longest_release == 99_ms);        // 2^24 cycles of 168 MHz are 99.86 ms, and the tick is 1 ms
  CHECK(slower.costs.release > slow.costs.release);  // more instants than the ring holds: each is planned
  const TaskSet set = make_task_set(slow, Profile::target);
  CHECK(std::any_of(set.streams.begin(), set.streams.end(), [](const Stream& s) { return s.separation == 99_ms; }));
}

TEST_CASE("who asks on CAN sends a frame and receives another") {
  const Robots robot = Robots::with(R"(<bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
      <device name="a" type="asker" period="2ms" bus="can" id="1"/>)");
  const auto& sources = *robot.model.buses[BusPlace{0}].sources;
  REQUIRE(sources.size() == 3);
  REQUIRE(sources[0].name == "rx");
  REQUIRE(sources[0].budgets.size() == 1);
  CHECK(sources[0].budgets.front().count == 1);
  CHECK(sources[0].min_interval > 105_us);  // 111 bits, by the part's clock
  REQUIRE(sources[1].name == "tx");
  CHECK(sources[1].min_interval == 55_us);
  const auto& transfers = robot.model.devices[Rank{0}].transfers;
  REQUIRE(transfers.size() == 1);
  CHECK(transfers.front().wire == longest_of_bits(*robot.robot, robot.robot->devices[robot.forest.order[Rank{0}]],
                                                  200_us));  // 65 bits and 135, by the part's clock
  CHECK(transfers.front().wire > 202_us);
}

TEST_CASE("interrupts of a bus are those of what its devices declare") {
  const std::string bus = R"(<bus name="i2c" type="i2c" port="i2c2" clock="400kHz"/>)";
  const std::string load = R"(<device name="load" type="sim_load" period="5ms"/>)";
  SECTION("an expander that nobody drives has none") {
    const Robots robot =
        Robots::with(bus + R"(<expander name="pwm" model="pca9685" bus="i2c" address="0x40"/>)" + load);
    CHECK(robot.model.buses[BusPlace{0}].sources->empty());
  }
  SECTION("a device that declares nothing asks as often as transfers can end, and once more") {
    const Robots robot = Robots::with(bus + R"(<device name="part" type="reticent" period="5ms" bus="i2c"/>)" + load);
    const auto& sources = *robot.model.buses[BusPlace{0}].sources;
    REQUIRE(sources.size() == 3);
    REQUIRE(sources[0].name == "request");
    REQUIRE(sources[2].name == "end");
    REQUIRE(sources[0].budgets.size() == 1);
    CHECK(sources[0].budgets[0].count == 1);
    CHECK(sources[0].budgets[0].interval == sources[2].min_interval);
    CHECK(sources[2].budgets.empty());
    Diagnostics findings;
    const auto timing = analyse(robot.model, {}, findings);
    REQUIRE(timing);
    CHECK(timing->schedulable);
  }
}

TEST_CASE("what publishes a value for a faster bucket counts with the stage that makes it") {
  RobotPlan plan(R"(<device name="root" type="group" period="1ms">
    <device name="slow" type="group" period="20ms">
      <device name="leaf" type="sim_load" period="20ms"/>
      <device name="fast" type="sim_load" period="1ms"/>
    </device>
  </device>)");
  INFO(plan.said());
  ComputedCosts costs;
  std::int64_t number = 1;
  for (std::size_t device = 0; device < plan.forest.order.size(); ++device, number += 2)
    costs.before.push_back({nanoseconds(number * 100), nanoseconds(number * 100 + 100)});
  costs.behind = {{1_ms, 30_ns}, {20_ms, 40_ns}};
  plan.robot->computed = costs;
  const auto extras = [&] {
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> result;
    const auto model = make_timing_model(*plan.robot, plan.forest, plan.schedule, plan.diagnostics);
    REQUIRE(model);
    for (const timing::Device& d : model->devices) result[d.name] = {d.update_extra.ns(), d.handle_extra.ns()};
    return result;
  };
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> expected;
  for (const DeviceId device : plan.forest.order) {
    const auto& before = costs.before[device];
    expected[plan.name(device)] = {before.update.ns(), before.handle.ns()};
  }
  const auto between = [](const Crossing& c) { return c.kind == Crossing::Kind::to_fast; };
  REQUIRE(std::count_if(plan.schedule.crossings.begin(), plan.schedule.crossings.end(), between) == 2);

  const auto move = [](std::int64_t& from, std::int64_t& to) { to += std::exchange(from, 0); };
  move(expected["slow"].second, expected["slow"].first);   // its state, after which its own handle() comes
  move(expected["leaf"].second, expected["slow"].second);  // its command to `fast`
  CHECK(extras() == expected);
}

TEST_CASE("costs that add up to more than 64 bits hold are reported at the first device") {
  Robots finsrov("examples/finsrov.urdf");
  using BoardCosts = finemote::gen::Costs;
  Board board = *finsrov.robot->board;
  const auto diagnostics_with = [&](Duration BoardCosts::*cost) {
    board.costs_in_sram = finsrov.robot->board->costs_in_sram;
    board.costs_in_sram.*cost = Duration::max();
    Robot robot = *finsrov.robot;
    robot.board = &board;
    Diagnostics diagnostics;
    CHECK_FALSE(make_timing_model(robot, finsrov.forest, finsrov.schedule, diagnostics));
    return diagnostics;
  };
  for (const auto cost : {&BoardCosts::release, &BoardCosts::exception_entry, &BoardCosts::latch_per_word,
                          &BoardCosts::flush_expander_per_channel}) {
    const auto findings = diagnostics_with(cost).in_file_order();
    REQUIRE(findings.size() == 1);
    CHECK(findings.front().code == code::timing_overflow);
    CHECK(findings.front().at.line == finsrov.model.devices[Rank{}].at.line);
  }
}
