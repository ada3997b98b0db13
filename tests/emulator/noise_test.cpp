// A serial line full of damaged bytes: its interrupts stay within what analyze allows, and frames come again after it.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/emulator/routines.hpp"
#include "tests/figures.hpp"

using namespace finemote::test;

namespace {

using Json = nlohmann::json;

constexpr double kNoiseEndsNs = 300e6;

/// Noise every millisecond on both lines from 50 ms on: single bytes, bursts, and bytes without a gap.
std::string noise() {
  Json events = Json::array();
  for (int ms = 50; ms < 280; ++ms) {
    for (const char* port : {"usart1", "usart3"}) {
      const int bytes = ms == 150 ? 500 : 1 + ms % 8;
      events.push_back({{"t_ns", ms * 1'000'000}, {"port", port}, {"do", "noise"}, {"bytes", bytes}});
    }
  }
  return Json{{"schema", "finemote.scenario/1"}, {"events", events}}.dump();
}

const Json& source_of(const Json& analysis, const std::string& bus, const std::string& name) {
  for (const Json& one : analysis["model"]["buses"]) {
    if (one["name"] != bus) continue;
    for (const Json& source : one["sources"]) {
      if (source["name"] == name) return source;
    }
  }
  FAIL("no source " << bus << '.' << name);
  return analysis;
}

/// Interrupts of line events that a window of this length holds at most.
double allowed(const Json& source, double period, double window) {
  const Json& budget = source["budgets"][0];
  const double looks = std::ceil(window / period) + budget["carry_in"].get<double>();
  return std::min(std::ceil(window / source["min_interval_ns"].get<double>()), budget["count"].get<double>() * looks);
}

/// The most interrupts of any window of this length.
double most_in(const std::vector<double>& begins, double window) {
  std::size_t most = 0, first = 0;
  for (std::size_t last = 0; last < begins.size(); ++last) {
    while (begins[last] - begins[first] >= window) ++first;
    most = std::max(most, last - first + 1);
  }
  return static_cast<double>(most);
}

void check_line(const std::map<int, Routine>& routines, const Json& analysis, const std::string& bus,
                const std::string& line, double period) {
  const Json& source = source_of(analysis, bus, "rx_idle");
  for (const auto& [number, routine] : routines) {
    if (routine.meaning.is_null() || routine.meaning.value("source", "") != line) continue;
    REQUIRE(routine.begins.size() > 40);
    for (const double window : {0.3e6, 1e6, 2e6, 5e6, 20e6, 100e6}) {
      INFO(bus << ", window of " << window << " ns");
      CHECK(most_in(routine.begins, window) <= allowed(source, period, window));
    }
    constexpr double kWayInAndOut = 200;  // of the emulated core; what is charged for it is more
    const double bound = source["wcet_ns"].get<double>() + kWayInAndOut;
    CHECK(longest(routine.own) <= bound);
    return;
  }
  FAIL("no routine of " << line);
}

/// Good bytes that nobody declared, on both lines without a gap.
std::string flood(int byte) {
  Json events = Json::array();
  for (const char* port : {"usart1", "usart3"}) {
    const int bytes = std::string(port) == "usart1" ? 20'000 : 2'000;
    events.push_back({{"t_ns", 30'000'000}, {"port", port}, {"do", "flood"}, {"bytes", bytes}, {"byte", byte}});
  }
  return Json{{"schema", "finemote.scenario/1"}, {"events", events}}.dump();
}

/// The time of the last sample that a device used.
double last_used(const std::string& audit, const std::string& device) {
  double last = 0;
  std::istringstream lines(read_file(audit));
  for (std::string text; std::getline(lines, text);) {
    if (text.find("\"used\"") == std::string::npos) continue;
    const Json line = Json::parse(text);
    if (line["what"] == "used" && line["device"] == device) last = line["t"].get<double>() / 1000;
  }
  return last;
}

}  // namespace

TEST_CASE("a noisy line interrupts no more often than analyze counts, and is heard again") {
  const TemporaryFolder folder;
  write_file(folder.path("noise.json"), noise());
  const std::string robot = source_path("tests/emulator/bounds/noisy_line.urdf"), audit = folder.path("audit.jsonl");
  const Json document =
      finemote_json({"run", robot, "--duration", "400ms", "--scenario", folder.path("noise.json"), "--audit", audit});
  const Json analysis = finemote_json({"analyze", robot});
  const auto routines = routines_of(audit);
  check_line(routines, analysis, "fast", "USART1", 2e6);
  check_line(routines, analysis, "slow", "USART3", 5e6);
  CHECK(last_used(audit, "imu") > kNoiseEndsNs + 50e6);
  CHECK(last_used(audit, "remote") > kNoiseEndsNs + 50e6);
  CHECK(document["overruns"] == 0);
  REQUIRE(!document["responses"].empty());
  for (const Json& device : document["responses"]) {
    INFO(device.dump());
    CHECK(device["judged"] == "held");
  }
  REQUIRE(document["buses"].size() == 2);
  for (const Json& bus : document["buses"]) CHECK(bus["errors"] > 0);
}

TEST_CASE("bytes that nobody declared take no update longer than its WCET") {
  const TemporaryFolder folder;
  const std::string file = folder.path("flood.json"), lines = source_path("tests/emulator/bounds/");
  for (const char* robot : {"noisy_line.urdf", "two_receivers.urdf"}) {
    for (const int byte : {0x00, 0x0F, 0x59, 0xA5}) {
      INFO(robot << ", " << byte);
      write_file(file, flood(byte));
      const Json document = finemote_json({"run", lines + robot, "--duration", "150ms", "--scenario", file});
      CHECK(document["overruns"] == 0);
      check_own_times(document);
    }
  }
}
