// Whose samples have no age that anybody knows, and which commands leave late.
#include "catch.hpp"
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
        "the part of 'own' sends it something, and its type does not say how old that is ('acquisition')");
}

TEST_CASE("a measurement may find its slot taken by another stage of its device, again and again") {
  const Timing timing = timing_of(kI2c, R"(type="seesaw")");
  CHECK_FALSE(chain(timing, "own", "own").acquire);
  REQUIRE(timing.missing.size() == 1);
  CHECK(timing.missing.front().why ==
        "a measurement of 'own' may find its slot taken by what another stage sends: its type does not say how many in "
        "a row ('published_every' of 'acquisition')");
  const auto told = chain(timing_of(kI2c, R"(type="told_seesaw")"), "own", "own").acquire;
  REQUIRE(told);
  CHECK(*told >= finemote::gen::milliseconds(10));
}

TEST_CASE(
    "a question still takes the slot when handle() wants to send: the command leaves with the next job, on CAN, too") {
  for (const auto& [bus, device] :
       {std::pair(kI2c, R"(type="seesaw")"), std::pair(kCan, R"(type="late_on_can" id="3")")}) {
    INFO(device);
    const auto wire = chain(timing_of(bus, device), "own", "own").wire;
    REQUIRE(wire);
    CHECK(*wire > finemote::gen::milliseconds(5));
  }
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
}
