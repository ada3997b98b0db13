// The sweeps behind the costs that the chip's file calls measured: no routine takes longer than its figure says, and
// the worst one of a sweep comes near it.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

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

/// Of the sections of a record that keep all interrupts out [ns].
double longest_masked_in(const std::string& audit) {
  double most = 0, begin = 0;
  std::istringstream lines(read_file(audit));
  for (std::string text; std::getline(lines, text);) {
    if (text.find("mask\"") == std::string::npos) continue;
    const Json event = Json::parse(text);
    const double at = event["t"].get<double>() / 1000;
    if (event["what"] == "mask") begin = at;
    if (event["what"] == "unmask") most = std::max(most, at - begin);
  }
  return most;
}

/// What ran, beside what analyze says of it.
struct Swept {
  Json model;
  std::map<int, Routine> routines;
  double longest_masked = 0;  ///< ns

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
  /// The exception whose meaning has this member with this value.
  [[nodiscard]] const Routine& routine(const std::string& member, const std::string& value) const {
    const auto found = std::find_if(routines.begin(), routines.end(), [&](const auto& one) {
      return one.second.meaning.is_object() && one.second.meaning.value(member, "") == value;
    });
    REQUIRE(found != routines.end());
    return found->second;
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

/// What else the commands of a sweep are given.
struct Setting {
  std::string devices = source_path("tests/emulator/sweeps/devices");
  std::string code = "sram", tick = "1ms";
  std::string scenario;
  std::vector<std::string> options;  ///< of run and analyze
};

/// Runs a robot with this body of its `<finemote>` for a few hundred milliseconds.
Swept sweep(const std::string& body, const Setting& setting = {}) {
  const TemporaryFolder folder;
  const std::string robot = folder.path("robot.urdf"), audit = folder.path("audit.jsonl");
  write_file(robot,
             "<robot name=\"sweep\">\n<link name=\"base_link\"/>\n<finemote version=\"1\">\n"
             "<board name=\"robomaster_type_c\" tick=\"" +
                 setting.tick + "\"><param name=\"code\">" + setting.code + "</param></board>\n" + body +
                 "</finemote>\n</robot>\n");
  std::vector<std::string> analyze{"analyze", robot, "--device-path", setting.devices};
  analyze.insert(analyze.end(), setting.options.begin(), setting.options.end());
  std::vector<std::string> run = analyze;
  run.front() = "run";
  run.insert(run.end(), {"--duration", "150ms", "--audit", audit, "--allow-unschedulable"});
  if (!setting.scenario.empty()) {
    write_file(folder.path("scenario.json"), setting.scenario);
    run.insert(run.end(), {"--scenario", folder.path("scenario.json")});
  }
  finemote_json(run);
  return {finemote_json(analyze)["model"], routines_of(audit), longest_masked_in(audit)};
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

/// Devices that do nothing but take 1 us in update() and in handle(), by period in milliseconds.
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

/// Exchanges of 64 bytes, by DMA or with an interrupt for every byte.
std::string exchanges(const std::string& port, int clock_khz, int devices, int period_ms) {
  std::string list = fmt::format("<bus name=\"spi\" type=\"spi\" port=\"{}\" clock=\"{}kHz\"/>\n", port, clock_khz);
  for (int i = 0; i < devices; ++i)
    list += fmt::format("<device name=\"e{0}\" type=\"exchange\" bus=\"spi\" channel=\"{0}\" period=\"{1}ms\"/>\n", i,
                        period_ms);
  return list;
}

/// Devices that ask on an RS-485 line, which another looks at more often.
std::string questions(int devices) {
  std::string list = R"(
<bus name="line" type="rs485" port="usart1" baud="921600baud"><param name="direction">PI0</param></bus>
<device name="often" type="sim_load" period="1ms"><param name="update">1us</param><param name="handle">1us</param></device>
)";
  for (int id = 1; id <= devices; ++id)
    list += fmt::format("<device name=\"ask{0}\" type=\"questioner\" bus=\"line\" id=\"{0}\" period=\"10ms\"/>\n", id);
  return list;
}

/// Drawn by the campaign, and shrunk: looks at an I2C bus find its transfer past the deadline, and going on.
const std::string kLateTransfer = R"(
<bus name="compass" type="i2c" port="i2c3" clock="400kHz"/>
<bus name="wire" type="i2c" port="i2c2" clock="200kHz"/>
<bus name="line_usart6" type="uart" port="usart6" baud="460800baud"/>
<bus name="spi" type="spi" port="spi1" clock="5250kHz"/>
<device name="mixer_8" type="mixer" period="1000us">
<device name="ist8310_2" type="ist8310" period="13000us" bus="compass" role="inputs"/>
<device name="gauge_3" type="gauge" period="5000us" bus="wire" address="0x2c" role="gauges"/>
<device name="host_link_4" type="host_link" period="20000us" bus="line_usart6" role="inputs">
<device name="load_5" type="restless" period="2500us">
<param name="update">30640ns</param>
<param name="handle">226287ns</param>
<param name="seed">217169</param>
</device>
</device>
<device name="bmi088_7" type="bmi088" period="1000us" bus="spi" channel="0" role="inputs">
<use role="gyro" bus="spi" channel="1"/>
<use role="ready" pin="bmi088_int_gyro"/>
</device>
</device>
<device name="load_18" type="restless" period="500us">
<param name="update">7404ns</param>
<param name="handle">43957ns</param>
<param name="seed">189051</param>
</device>
)";

/// Bytes that answer every question, and fill a ring several times.
const std::string kFlood = R"({"schema": "finemote.scenario/1", "events": [
  {"t_ns": 30000000, "port": "usart1", "do": "flood", "bytes": 10000, "byte": 85}]})";

Setting flooded() {
  Setting setting;
  setting.scenario = kFlood;
  return setting;
}

/// An inertial sensor and a remote control, each on a line of its own.
const std::string kLines = R"(
<bus name="fast" type="uart" port="usart1" baud="921600baud"/>
<bus name="slow" type="uart" port="usart3" baud="100000baud"/>
<device name="imu" type="h30_imu" bus="fast" period="5ms"/>
<device name="remote" type="dr16" bus="slow" period="5ms"/>
)";

}  // namespace

TEST_CASE("serial lines: events and ends of laps and of what is sent") {
  Held events, laps, ends;
  const Swept lines = sweep(kLines, flooded()), asked = sweep(questions(2), flooded());
  for (const char* line : {"USART1", "USART3"})
    events.add(line, lines.longest_own("source", line), lines.source("rx_idle"));
  laps.add("laps of a UART", lines.longest_own("source", "DMA2_Stream5"), lines.source("rx_dma"));
  laps.add("laps of an RS-485 line", asked.longest_own("source", "DMA2_Stream5"), asked.source("rx_dma"));
  ends.add("ends of a question", asked.longest_own("source", "USART1"), asked.source("tx_complete"));
  events.check_near(0.8);
  laps.check_near(0.8);
  ends.check_near(0.8);
}

TEST_CASE("sections that keep all interrupts out") {
  Held held;
  Setting in_sram, in_flash;
  in_flash.code = "flash";
  for (const Setting& setting : {in_sram, in_flash}) {
    for (const std::string& body : {kLines, on_i2c(400, 2)}) {
      const Swept swept = sweep(body, setting);
      held.add("code in " + setting.code, swept.longest_masked, swept.model["costs"]["masked_ns"].get<double>());
    }
  }
  held.check_near(0.8);
}

TEST_CASE("SPI with DMA: requests and ends, 64 bytes copied both ways") {
  Held requests, ends;
  for (const int clock : {657, 5250, 10500}) {
    const Swept one = sweep(exchanges("spi1", clock, 1, 4)), two = sweep(exchanges("spi1", clock, 2, 4));
    const std::string what = fmt::format("{} kHz", clock);
    // No other waits after the one, so that its end begins none: the longer of its two routines is the request.
    requests.add(what, one.longest_own("bus", "spi"), one.source("request"));
    ends.add(what, two.longest_own("bus", "spi"), two.source("end"));
  }
  requests.check_near(0.8);
  ends.check_near(0.8);
}

TEST_CASE("SPI without DMA: steps, ends and requests") {
  Held steps;
  const Swept swept = sweep(exchanges("spi2", 5250, 1, 4));
  std::vector<double> own = swept.routine("bus", "spi").own;
  std::sort(own.begin(), own.end());
  REQUIRE(own.size() > 1000);
  steps.add("most", own[own.size() / 2], swept.source("step"));
  steps.check_near(0.8);
  CHECK(own.back() <= swept.source("request"));
}

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
  hold("exchanges", sweep(exchanges("spi1", 5250, 2, 4)));
  for (const int devices : {2, 90}) hold(fmt::format("questions of {}", devices), sweep(questions(devices), flooded()));
  Setting drawn;
  drawn.devices = source_path("tests/campaign/devices");
  drawn.tick = "500us";
  hold("a late transfer", sweep(kLateTransfer, drawn));
  Setting watched;
  watched.options = {"--monitor"};
  for (const std::size_t devices : {1, 10})
    hold(fmt::format("{} devices and the monitor", devices), sweep(loads(std::vector<int>(devices, 4)), watched));
  held.check_near(0.75);
}
