// The sweeps behind the costs that the chip's file calls measured: no routine takes longer than its figure says, and
// the worst one of a sweep comes near it.
#include <fmt/format.h>

#include <algorithm>

#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/emulator/routines.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

/// What ran, beside what analyze says of it.
struct Swept {
  Json model;
  std::map<int, Routine> routines;

  [[nodiscard]] double interrupt() const { return model["costs"]["interrupt_ns"]; }
  [[nodiscard]] double source(const std::string& name) const {
    for (const Json& one : model["buses"][0]["sources"]) {
      if (one["name"] == name) return one["wcet_ns"].get<double>() + interrupt();
    }
    FAIL("no source " << name);
    return 0;
  }
  /// Of the exceptions whose meaning has this member with this value.
  [[nodiscard]] double longest_own(const std::string& member, const std::string& value) const {
    double most = 0;
    for (const auto& [number, routine] : routines) {
      const bool is_it = routine.meaning.is_object() && routine.meaning.value(member, "") == value;
      if (is_it) most = std::max(most, longest(routine.own));
    }
    REQUIRE(most > 0);
    return most;
  }
};

/// Runs a robot with this body of its `<finemote>` for a few hundred milliseconds.
Swept sweep(const std::string& body, const std::string& board = "") {
  const TemporaryFolder folder;
  const std::string robot = folder.path("robot.urdf"), audit = folder.path("audit.jsonl");
  write_file(robot,
             "<robot name=\"sweep\">\n<link name=\"base_link\"/>\n<finemote version=\"1\">\n"
             "<board name=\"robomaster_type_c\"" +
                 board + "/>\n" + body + "</finemote>\n</robot>\n");
  finemote_json({"run", robot, "--duration", "150ms", "--audit", audit, "--allow-unschedulable"});
  return {finemote_json({"analyze", robot, "--allow-unschedulable"})["model"], routines_of(audit)};
}

/// Holds the longest run against its bound.
class Held {
 public:
  void add(const std::string& what, double seen, double bound) {
    INFO(what << ": " << seen << " ns of " << bound << " ns");
    CHECK(seen <= bound);
    nearest_ = std::max(nearest_, seen / bound);
  }
  /// No figure of the sweep is far too large.
  void check_near(double least) const { CHECK(nearest_ >= least); }

 private:
  double nearest_ = 0;
};

std::string motors(int count, int first_period_ms, int second_period_ms) {
  std::string list;
  for (int i = 1; i <= count; ++i)
    list += fmt::format("<device name=\"m{0}\" type=\"dji_m3508\" period=\"{1}ms\" bus=\"can\" id=\"{0}\"/>\n", i,
                        i <= 4 ? first_period_ms : second_period_ms);
  return list;
}

const std::string kCan = "<bus name=\"can\" type=\"can\" port=\"can1\" bitrate=\"1Mbit/s\"/>\n";

/// Four frames of one flush, of which three find a mailbox.
const std::string kFourFrames = R"(
<device name="a" type="dji_m3508" period="2ms" bus="can" id="1"/>
<device name="b" type="dji_m3508" period="2ms" bus="can" id="8"/>
<device name="c" type="dji_gm6020" period="2ms" bus="can" id="1"/>
<device name="d" type="dji_gm6020" period="2ms" bus="can" id="5"/>
)";

/// Servos on as many expanders, and a pressure sensor.
std::string on_i2c(int clock_khz, int expanders) {
  std::string parts = fmt::format("<bus name=\"i2c\" type=\"i2c\" port=\"i2c2\" clock=\"{}kHz\"/>\n", clock_khz);
  std::string devices = R"(<device name="depth" type="ms5837" period="5ms" bus="i2c" address="0x76"/>)";
  for (int i = 0; i < expanders; ++i) {
    parts += fmt::format("<expander name=\"p{}\" model=\"pca9685\" bus=\"i2c\" address=\"{:#x}\"/>\n", i, 0x40 + i);
    devices += fmt::format("<device name=\"s{0}\" type=\"pwm_servo\" period=\"5ms\" bus=\"p{0}\" channel=\"0\"/>\n", i);
  }
  return parts + "<device name=\"all\" type=\"group\" period=\"5ms\">\n" + devices + "</device>\n";
}

}  // namespace

TEST_CASE("CAN: a frame received, and a request with its frames, by devices on the bus") {
  Held received, sent;
  for (const std::string& devices : {motors(1, 1, 1), motors(4, 1, 1), motors(8, 2, 2), motors(8, 2, 3), kFourFrames}) {
    const Swept swept = sweep(kCan + devices);
    received.add(devices, swept.longest_own("source", "CAN1_RX0"), swept.source("rx"));
    sent.add(devices, swept.longest_own("source", "CAN1_TX"), std::max(swept.source("tx"), swept.source("request")));
  }
  received.check_near(0.8);
  sent.check_near(0.8);
}

TEST_CASE("I2C: requests, steps and ends, by clock and devices on the bus") {
  Held held;
  for (const int clock : {100, 400}) {
    for (const int expanders : {0, 1, 5}) {
      const Swept swept = sweep(on_i2c(clock, expanders));
      const double bound = std::max({swept.source("request"), swept.source("step"), swept.source("end")});
      held.add(fmt::format("{} kHz, {} expanders", clock, expanders), swept.longest_own("bus", "i2c"), bound);
    }
  }
  held.check_near(0.7);
}
