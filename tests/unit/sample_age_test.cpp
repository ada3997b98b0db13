// Whose samples have no age that anybody knows, and which commands leave late.
#include <fmt/format.h>

#include <algorithm>

#include "catch.hpp"
#include "generator/timing/json.hpp"
#include "generator/timing/table.hpp"
#include "timing_robots.hpp"

using namespace finemote::gen::timing;
using finemote::gen::Diagnostics;

namespace {

/// Of one device, `own`, alone on a bus.
Timing timing_of(const std::string& bus, const std::string& device, std::vector<Requirement> requirements = {}) {
  const Robots robot =
      Robots::with("<bus name=\"line\" " + bus + "/><device name=\"own\" bus=\"line\" period=\"5ms\" " + device + "/>");
  Diagnostics findings;
  AnalysisRequest request;
  request.requirements = std::move(requirements);
  auto timing = analyse(robot.model, request, findings);
  REQUIRE(timing);
  return std::move(*timing);
}

const std::string kI2c = R"(type="i2c" port="i2c2" clock="400kHz")";
const std::string kCan = R"(type="can" port="can1" bitrate="1Mbit/s")";

}  // namespace

TEST_CASE("what a part sends is as old as nobody knows where its type does not say it") {
  const Timing timing = timing_of(kI2c, R"(type="ageless")");
  CHECK_FALSE(chain(timing, "own", "own").acquire);
  CHECK(chain(timing, "own", "own").decide);
  CHECK(chain(timing, "own", "own").wire);
  REQUIRE(timing.missing.size() == 1);
  CHECK(timing.missing.front().why ==
        "what 'own' reads is older than its update(), and its type does not say how much ('acquisition')");
}

TEST_CASE("what a part measures by itself is read a period after update() has asked for it") {
  const auto acquire = chain(timing_of(kI2c, R"(type="free_running")"), "own", "own").acquire;
  REQUIRE(acquire);
  CHECK(*acquire > finemote::gen::milliseconds(6));
}

TEST_CASE("a part has one wire for what it answers and for what it sends by itself") {
  const std::string uart = R"(type="uart" port="usart1" baud="115200baud")";
  const auto acquire = chain(timing_of(uart, R"(type="streams_and_answers")"), "own", "own").acquire;
  REQUIRE(acquire);
  // Interval, the answer of 32 bytes that has just begun, and the sample's 20 bytes, by a clock that is 1 % slow.
  CHECK(*acquire > finemote::gen::microseconds(24'760));
}

TEST_CASE("on CAN an answer may come as late as its measurement takes, and lets others wait then") {
  const auto wire_beside = [](const std::string& type) {
    const Robots robot = Robots::with("<bus name=\"can\" " + kCan + "/>" + R"(
        <device name="p" bus="can" period="1ms" id="1" type=")" +
                                      type + R"("/>
        <device name="q" bus="can" period="1ms" id="2" type=")" +
                                      type + R"("/>
        <device name="own" bus="can" period="10ms" id="3" type="late_on_can"/>)");
    Diagnostics findings;
    const auto timing = analyse(robot.model, {}, findings);
    REQUIRE(timing);
    const auto wire = chain(*timing, "own", "own").wire;
    REQUIRE(wire);
    return *wire;
  };
  // Those of the jobs before, of both.
  CHECK(wire_beside("slow_asker") >= wire_beside("asker") + finemote::gen::microseconds(400));
}

TEST_CASE("a measurement may find its slot taken by another stage of its device, again and again") {
  const Timing timing = timing_of(kI2c, R"(type="seesaw")");
  CHECK_FALSE(chain(timing, "own", "own").acquire);
  REQUIRE(timing.missing.size() == 1);
  CHECK(timing.missing.front().why ==
        "a measurement of 'own' may find its slot taken by another transfer of its own: its type does not say how many "
        "in a row ('published_every' of 'acquisition')");
  const auto told = chain(timing_of(kI2c, R"(type="told_seesaw")"), "own", "own").acquire;
  REQUIRE(told);
  CHECK(*told >= finemote::gen::milliseconds(10));
  CHECK_FALSE(chain(timing_of(kI2c, R"(type="asks_and_sets")"), "own", "own").acquire);
  const Timing turns = timing_of(kI2c, R"(type="takes_turns")");
  CHECK_FALSE(chain(turns, "own", "own").acquire);
  CHECK(chain(turns, "own", "own").wire.value() > finemote::gen::milliseconds(5));
}

TEST_CASE(
    "a question still takes the slot when handle() wants to send: the command leaves with the next job, on CAN, too") {
  for (const auto& [bus, device] : {std::pair(kI2c, R"(type="seesaw")"), std::pair(kI2c, R"(type="asks_and_sets")"),
                                    std::pair(kCan, R"(type="late_on_can" id="3")")}) {
    INFO(device);
    const auto wire = chain(timing_of(bus, device), "own", "own").wire;
    REQUIRE(wire);
    CHECK(*wire > finemote::gen::milliseconds(5));
  }
}

TEST_CASE("a command waits for as many jobs as the transfers of its device take turns, each until it has ended") {
  const auto wire = [](const std::string& clock) {
    return chain(timing_of(R"(type="i2c" port="i2c2" clock=")" + clock + "\"", R"(type="asks_and_sets")"), "own", "own")
        .wire;
  };
  REQUIRE(wire("400kHz"));
  CHECK(*wire("400kHz") > finemote::gen::milliseconds(5));
  CHECK(*wire("400kHz") < finemote::gen::milliseconds(10));
  CHECK((!wire("10kHz") || *wire("10kHz") > finemote::gen::milliseconds(15)));
}

TEST_CASE("what comes by itself is as old as nobody knows where its type says that it is asked for") {
  const Timing timing = timing_of(kCan, R"(type="never_asked")");
  CHECK_FALSE(chain(timing, "own", "own").acquire);
  REQUIRE(timing.missing.size() == 1);
  CHECK(timing.missing.front().why ==
        "'own' receives data that it has not asked for, but its type is 'polled' and does not say how often they come");
  CHECK_FALSE(chain(timing_of(kCan, R"(type="asked_and_told")"), "own", "own").acquire);
  CHECK(chain(timing_of(kCan, R"(type="asked_and_warned")"), "own", "own").acquire);
}

TEST_CASE("what update() sets of an output or a pin leaves a period later than what handle() sets") {
  const auto wire = [](const std::string& device) {
    const Robots robot = Robots::with("<bus name=\"line\" type=\"pwm\" port=\"pwm1\"/><device name=\"own\" " + device);
    Diagnostics findings;
    const auto timing = analyse(robot.model, {}, findings);
    REQUIRE(timing);
    return chain(*timing, "own", "own").wire.value();
  };
  CHECK(wire(R"(type="pwm_servo" period="5ms" bus="line"/>)") < finemote::gen::milliseconds(1));
  CHECK(wire(R"(type="late_pulse" period="5ms" bus="line"/>)") > finemote::gen::milliseconds(5));
  CHECK(wire(R"(type="late_switch" period="5ms"><use role="line" pin="laser"/></device>)") >
        finemote::gen::milliseconds(5));
}

TEST_CASE("others may go between a question on CAN and its answer") {
  std::string motors;
  for (int id = 1; id <= 6; ++id)
    motors += fmt::format(R"(<device name="m{0}" type="dji_m3508" bus="line" id="{0}"/>)", id);
  Robots robot = Robots::with("<bus name=\"line\" " + kCan + R"(/><device name="root" type="group" period="5ms">
    <device name="own" type="asks_on_can" bus="line" id="8"/>)" +
                              motors + "</device>");
  const auto wire = [&] {
    Diagnostics findings;
    const auto timing = analyse(robot.model, {}, findings);
    REQUIRE(timing);
    return chain(*timing, "own", "own").wire.value();
  };
  auto& transfers = robot.model.devices[robot["own"]].transfers;
  REQUIRE(transfers.size() == 1);
  CHECK(transfers.front().frames == 2);
  const auto apart = wire();
  transfers.front().frames = 1;
  CHECK(wire() < apart);
}

namespace {

const std::string kBattery = R"(<use role="sense" pin="battery"/></device>)";

/// Acquire of a battery that is measured beside this much work in each millisecond.
finemote::gen::Duration acquire_beside(const std::string& work) {
  const Robots robot = Robots::with(R"(<device name="root" type="group" period="1ms">
    <device name="load" type="sim_load"><param name="update">)" +
                                    work + R"(</param></device>
    <device name="own" type="battery">)" +
                                    kBattery + "</device>");
  Diagnostics findings;
  const auto timing = analyse(robot.model, {}, findings);
  REQUIRE(timing);
  return chain(*timing, "own", "load").acquire.value();
}

}  // namespace

TEST_CASE("a conversion that may not have ended by the next update() takes another period") {
  CHECK(acquire_beside("100us") < finemote::gen::milliseconds(2));
  CHECK(acquire_beside("970us") > finemote::gen::milliseconds(3));
}

TEST_CASE("what a converter measured is as old as nobody knows where no type says it, and where others use it, too") {
  const std::string ageless = R"(<device name="own" type="volts_of_any_age" period="5ms">)";
  CHECK(Robots::with(ageless + kBattery).model.devices[finemote::gen::Rank{0}].unknown_age ==
        UnknownAge::no_acquisition);
  Robots robot = Robots::with(R"(<device name="root" type="group" period="5ms">
    <device name="load" type="sim_load"/><device name="own" type="battery">)" +
                              kBattery + "</device>");
  CHECK(robot.model.devices[robot["own"]].unknown_age == UnknownAge::none);
  auto& devices = robot.robot->devices;
  const auto named = [&](const std::string& name) -> auto& {
    return *std::find_if(devices.begin(), devices.end(), [&](const auto& d) { return d.name.text == name; });
  };
  named("load").uses = named("own").uses;
  Diagnostics findings;
  const auto model = make_timing_model(*robot.robot, robot.forest, robot.schedule, findings);
  REQUIRE(model);
  CHECK(model->devices[robot["own"]].unknown_age == UnknownAge::shared_converter);
  named("load").uses.clear();
  named("own").uses.push_back(named("own").uses.front());  // two inputs of one device keep each other waiting, too
  const auto alone = make_timing_model(*robot.robot, robot.forest, robot.schedule, findings);
  REQUIRE(alone);
  CHECK(alone->devices[robot["own"]].unknown_age == UnknownAge::shared_converter);
}

TEST_CASE("the last edge of a pin is as old as nobody knows where no type says it") {
  const auto age_of = [](const std::string& type) {
    const Robots robot =
        Robots::with(R"(<device name="own" type=)" + type + R"(><use role="line" pin="key"/></device>)");
    return robot.model.devices[finemote::gen::Rank{0}].unknown_age;
  };
  CHECK(age_of(R"("edge_of_any_age" period="5ms")") == UnknownAge::no_acquisition);
  CHECK(age_of(R"("key" period="5ms")") == UnknownAge::none);
}

TEST_CASE("nobody knows the load of a bus over which somebody may send anything") {
  Requirement requirement;
  requirement.kind = Requirement::Kind::utilization;
  requirement.bus = BusPlace{0};
  requirement.max_fraction = 0.9;
  const Timing declared = timing_of(kCan, R"(type="late_on_can" id="3")", {requirement});
  CHECK(declared.requirements.front().ok);
  const Timing timing = timing_of(kCan, R"(type="silent_on_can" id="3")", {requirement});
  CHECK_FALSE(timing.requirements.front().ok);
  CHECK_FALSE(timing.requirements.front().fraction);
  const std::string table = timing_table(timing);
  const auto ends_with = [](const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  };
  const std::string buses = table.substr(table.find("\nbuses\n")), requirements = buses.substr(buses.find("\nreq"));
  CHECK(requirements.find("90.0 %") != std::string::npos);
  CHECK(requirements.find(" ns") == std::string::npos);
  CHECK(ends_with(buses.substr(0, buses.find("\n\n")), "-"));
  CHECK(timing_json(timing)["requirements"][0]["slack"].is_null());
}
