// The sweeps behind the costs that the chip's file calls measured: no routine takes longer than its figure says, and
// the worst one of a sweep comes near it.
#include <fmt/format.h>

#include <algorithm>

#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/emulator/routines.hpp"
#include "tests/source_dir.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

/// What an interrupt makes others take longer is charged with it, and must not hide a routine that takes too long.
double preemption() {
  static const Json chip = Json::parse(read_file(source_dir() + "/schemas/chips/stm32f407.json"));
  return chip["costs"]["preemption"]["ns"].get<double>();
}

/// What ran, beside what analyze says of it.
struct Swept {
  Json model;
  std::map<int, Routine> routines;

  /// One run of a routine, and the way into it and back as the emulated core makes it, 22 cycles.
  [[nodiscard]] double source(const std::string& name) const {
    constexpr double kWayInAndOut = 131;
    for (const Json& one : model["buses"][0]["sources"]) {
      if (one["name"] == name) return one["wcet_ns"].get<double>() + kWayInAndOut;
    }
    FAIL("no source " << name);
    return 0;
  }
  /// What a job of a bucket may take besides its stages.
  [[nodiscard]] double around_stages(std::int64_t period) const {
    const Json& costs = model["costs"];
    double sum = costs["job_ns"].get<double>() - preemption();
    for (const Json& device : model["devices"]) {
      if (device["period_ns"] != period) continue;
      sum += 2 * costs["stage_ns"].get<double>() + device.value("update_extra_ns", 0.0) +
             device.value("handle_extra_ns", 0.0);
    }
    for (const Json& flush : model.value("flushes", Json::array())) {
      if (flush["period_ns"] == period) sum += flush["wcet_ns"].get<double>();
    }
    return sum;
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
Swept sweep(const std::string& body) {
  const TemporaryFolder folder;
  const std::string robot = folder.path("robot.urdf"), audit = folder.path("audit.jsonl");
  write_file(robot,
             "<robot name=\"sweep\">\n<link name=\"base_link\"/>\n<finemote version=\"1\">\n"
             "<board name=\"robomaster_type_c\"/>\n" +
                 body + "</finemote>\n</robot>\n");
  finemote_json({"run", robot, "--duration", "150ms", "--audit", audit, "--allow-unschedulable"});
  return {finemote_json({"analyze", robot})["model"], routines_of(audit)};
}

/// Holds the longest run against its bound.
class Held {
 public:
  void add(const std::string& what, double seen, double bound) {
    INFO(what << ": " << seen << " ns of " << bound << " ns");
    CHECK(seen <= bound);
    nearest_ = std::max(nearest_, seen / bound);
  }
  /// Some case of the sweep comes near its bound.
  void check_near(double least) const { CHECK(nearest_ >= least); }

 private:
  double nearest_ = 0;
};

/// All of one period: requests of several buckets may share a run, which then takes longer.
std::string motors(int count, int period_ms) {
  std::string list;
  for (int i = 1; i <= count; ++i)
    list += fmt::format("<device name=\"m{0}\" type=\"dji_m3508\" period=\"{1}ms\" bus=\"can\" id=\"{0}\"/>\n", i,
                        period_ms);
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

/// Devices that compute nothing but their turns, by period in milliseconds.
std::string loads(const std::vector<int>& periods) {
  std::string list;
  for (std::size_t i = 0; i < periods.size(); ++i)
    list += fmt::format(
        "<device name=\"load_{}\" type=\"sim_load\" period=\"{}ms\">"
        "<param name=\"update\">1us</param><param name=\"handle\">1us</param></device>\n",
        i, periods[i]);
  return list;
}

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
  for (const std::string& devices : {motors(1, 1), motors(4, 1), motors(8, 2), kFourFrames}) {
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
    for (const int expanders : clock == 400 ? std::vector<int>{0, 1, 5, 24} : std::vector<int>{0, 1, 5}) {
      const Swept swept = sweep(on_i2c(clock, expanders));
      const double bound = std::max({swept.source("request"), swept.source("step"), swept.source("end")});
      held.add(fmt::format("{} kHz, {} expanders", clock, expanders), swept.longest_own("bus", "i2c"), bound);
    }
  }
  held.check_near(0.7);
}

TEST_CASE("release: by buckets, in a ring of instants and planned anew") {
  Held held;
  for (const std::vector<int>& periods : std::vector<std::vector<int>>{
           {2}, {1, 2}, {3, 5}, {2, 3, 5, 7}, {2, 3, 5, 7, 11, 13}, {2, 3, 4, 5, 6, 7, 9, 11, 13, 17, 19}}) {
    const Swept swept = sweep(loads(periods));
    const Json& costs = swept.model["costs"];
    const double bound = costs["release_ns"].get<double>() - preemption() +
                         static_cast<double>(periods.size()) * costs["release_per_bucket_ns"].get<double>();
    held.add(fmt::format("{} buckets", periods.size()), swept.longest_own("kind", "release"), bound);
  }
  held.check_near(0.7);
}

TEST_CASE("jobs: by stages, and what a flush adds") {
  Held held;
  const auto hold = [&held](const std::string& what, const Swept& swept) {
    for (const auto& [number, routine] : swept.routines) {
      if (routine.meaning.is_null() || routine.meaning["kind"] != "bucket") continue;
      held.add(what, longest(routine.around), swept.around_stages(routine.meaning["period_ns"]));
    }
  };
  for (const std::size_t devices : {1, 10, 40})
    hold(fmt::format("{} devices", devices), sweep(loads(std::vector<int>(devices, 4))));
  for (const int count : {1, 8}) hold(fmt::format("{} motors", count), sweep(kCan + motors(count, 2)));
  for (const int expanders : {1, 4}) hold(fmt::format("{} expanders", expanders), sweep(on_i2c(400, expanders)));
  held.check_near(0.75);
}
