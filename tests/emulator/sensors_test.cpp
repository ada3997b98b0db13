// The sensors on the board, driven by an image made from a URDF: data-ready edges, the heater, and parts that fail.
#include <algorithm>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "emulator/outfit/outfit.hpp"
#include "tests/emulator/tested_chip.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

constexpr std::uint64_t kUs = 1'000, kMs = 1'000'000, kSecond = 1'000'000'000;
enum Sensor : unsigned { kImu, kCompass };

/// Events by scenario, times in ns since power-on.
struct Bench {
  explicit Bench(const std::string& events = "") {
    outfit.add(Json::parse(R"({"schema": "finemote.scenario/1", "parts": [
      {"type": "bmi088", "name": "imu", "port": "spi1", "channel": 0, "gyro": 1, "ready": "PC5",
       "heater": {"port": "imu_heater"}},
      {"type": "ist8310", "name": "compass", "port": "i2c3"}], "events": [)" +
                           events + "]}"));
    board.load(load_image(std::string(FINEMOTE_IMAGES) + "/sensors.elf"));
    Gpio& c = board.chip().gpio('C');
    c.on_level = [this, tell = c.on_level](unsigned pin, bool high) {
      if (pin == 5 && !high) edges.push_back(board.now_ns());
      tell(pin, high);
    };
    board.chip().gpio('B').on_output = [this](unsigned pin, bool output, bool high) {
      if (pin == 0 && output && !high) reads.push_back(board.now_ns());
    };
  }
  void run_to(std::uint64_t ns) { board.run_for(ns - board.now_ns()); }
  std::uint32_t seen(Sensor sensor, unsigned word) { return board.word("sensors_seen", 16 * sensor + 4 * word); }
  bool valid(Sensor sensor) { return seen(sensor, 0) != 0; }
  unsigned changes(Sensor sensor) { return seen(sensor, 1); }
  /// Since the first release [ns].
  std::int64_t origin(Sensor sensor) {
    return static_cast<std::int64_t>(std::uint64_t{seen(sensor, 3)} << 32 | seen(sensor, 2));
  }
  /// Time between power-on and the first release, from the cycle counter, which begins anew every 25 s.
  std::int64_t zero() {
    auto& world = board.world();
    const std::int64_t cycles = world.system().read(0xE0001004, 4, world.now(), 0);
    return static_cast<std::int64_t>(board.now_ns()) - cycles * 125 / 21;
  }
  std::uint64_t heater() {
    const auto [timer, channel] = board.chip().pwm("imu_heater");
    return timer->pulse(channel).width_ns;
  }
  double celsius() { return outfit.value("imu", "temperature"); }
  std::size_t edges_between(std::uint64_t from, std::uint64_t to) const {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [&](std::uint64_t at) { return at >= from && at < to; }));
  }
  void check_reports() {
    for (const Report& report : board.reports()) {
      INFO(name_of(report.misuse) << ": " << report.text);
      CHECK(false);
    }
  }

  Board board{finemote::test::type_c(), finemote::test::tested_chip()};
  Outfit outfit{board};
  std::vector<std::uint64_t> edges;  ///< of the gyroscope's data-ready line, into its active level
  std::vector<std::uint64_t> reads;  ///< when the gyroscope was selected
};

std::string at(std::uint64_t ns, const std::string& event) {
  return "{\"t_ns\": " + std::to_string(ns) + ", " + event + "}";
}
const char* const kSilent = R"("part": "imu", "do": "silent")";
const char* const kBack = R"("part": "imu", "do": "silent", "on": false)";

}  // namespace

TEST_CASE("the origin of the inertial sensor is never later than the data-ready edge before the read") {
  Bench bench;
  bench.run_to(500 * kMs);
  REQUIRE(bench.valid(kImu));
  CHECK(bench.edges_between(490 * kMs, 500 * kMs) == 10);
  const std::int64_t zero = bench.zero();
  unsigned looks = 0;
  for (std::uint64_t t = 500 * kMs; t < 900 * kMs; t += 700 * kUs) {
    bench.run_to(t);
    const std::int64_t origin = bench.origin(kImu) + zero;
    // The read of the job before the last has been published; the last one is under way.
    const std::uint64_t last = bench.reads.back(), read = bench.reads[bench.reads.size() - 2];
    bench.run_to(t + 100 * kUs);
    if (t - last < 100 * kUs || bench.reads.back() != last) continue;  // the job was perhaps at work
    const auto next = std::upper_bound(bench.edges.begin(), bench.edges.end(), read);
    REQUIRE(next != bench.edges.begin());
    const auto edge = static_cast<std::int64_t>(*(next - 1));
    CHECK(origin <= edge + 5'000);      // the interrupt takes some 2 us to note the time
    CHECK(origin >= edge - 2'000'000);  // it may have come right after the job's look, which the accelerometer precedes
    CHECK(static_cast<std::int64_t>(t) - origin < 6'000'000);
    ++looks;
  }
  CHECK(looks > 400);
  CHECK(bench.changes(kImu) == 1);
  bench.check_reports();
}

TEST_CASE("without edges the inertial sensor is invalid within 10 ms, and valid again when they are back") {
  Bench bench(at(1 * kSecond, R"("part": "imu", "do": "cut")") + "," +
              at(1500 * kMs, R"("part": "imu", "do": "cut", "on": false)"));
  bench.run_to(1 * kSecond);
  CHECK(bench.valid(kImu));
  bench.run_to(1010 * kMs);
  CHECK(!bench.valid(kImu));
  bench.run_to(1500 * kMs);
  CHECK(bench.changes(kImu) == 2);
  CHECK(bench.edges_between(1001 * kMs, 1500 * kMs) == 0);
  bench.run_to(2100 * kMs);
  CHECK(bench.valid(kImu));
  CHECK(bench.changes(kImu) == 3);
  CHECK(bench.changes(kCompass) == 1);
  bench.check_reports();
}

TEST_CASE("a silent or restarted inertial sensor gives no edges, is invalid within 6 ms, and is set up again") {
  Bench bench(at(1 * kSecond, kSilent) + "," + at(1500 * kMs, kBack) + "," +
              at(2500 * kMs, R"("part": "imu", "do": "power_cycle")"));
  bench.run_to(1 * kSecond);
  CHECK(bench.valid(kImu));
  bench.run_to(1006 * kMs);
  CHECK(!bench.valid(kImu));
  bench.run_to(1500 * kMs);
  CHECK(!bench.valid(kImu));
  CHECK(bench.edges_between(1 * kSecond + 1, 1500 * kMs) == 0);
  bench.run_to(2100 * kMs);
  CHECK(bench.valid(kImu));
  bench.run_to(2506 * kMs);
  CHECK(!bench.valid(kImu));
  bench.run_to(3100 * kMs);
  CHECK(bench.valid(kImu));
  CHECK(bench.edges_between(2500 * kMs + 1, 2600 * kMs) == 0);
  CHECK(bench.edges_between(3090 * kMs, 3100 * kMs) == 10);
  bench.check_reports();
}

TEST_CASE("a reset of the chip does not stop the part's edges, and ends the heat until its temperature is known") {
  Bench bench(at(3 * kSecond + 100 * kUs, R"("do": "reset")"));
  bench.run_to(3 * kSecond);
  REQUIRE(bench.heater() > 0);
  std::vector<std::uint64_t> pulses;
  const auto [timer, channel] = bench.board.chip().pwm("imu_heater");
  timer->on_pulse = [&pulses, mine = channel, tell = timer->on_pulse](unsigned which, Timer::Pulse pulse) {
    if (which == mine) pulses.push_back(pulse.width_ns);
    tell(which, pulse);
  };
  bench.run_to(3 * kSecond + 101 * kUs);
  CHECK(bench.heater() == 0);
  CHECK(bench.outfit.value("imu", "heat") == 0);
  bench.run_to(3030 * kMs);
  CHECK(bench.edges_between(3001 * kMs, 3030 * kMs) == 29);
  while (bench.board.now_ns() < 4 * kSecond && !bench.valid(kImu)) {
    bench.run_to(bench.board.now_ns() + 1 * kMs);
    if (!bench.valid(kImu)) CHECK(bench.heater() == 0);
  }
  CHECK(bench.valid(kImu));
  CHECK(bench.board.now_ns() < 3500 * kMs);
  REQUIRE(!pulses.empty());
  CHECK(pulses.front() == 0);
  bench.check_reports();
}

TEST_CASE("the heater brings the inertial sensor to its temperature and holds it there") {
  Bench bench;
  double hottest = 0;
  for (std::uint64_t t = 100 * kMs; t < 30 * kSecond; t += 100 * kMs) {
    bench.run_to(t);
    hottest = std::max(hottest, bench.celsius());
    CHECK(bench.heater() <= 500'000);  // of a millisecond: heater_limit
  }
  CHECK(hottest < 44);
  CHECK(bench.celsius() == Approx(40).margin(1));
  bench.run_to(60 * kSecond);
  CHECK(bench.celsius() == Approx(40).margin(0.5));
  CHECK(bench.outfit.value("imu", "heat") == Approx(0.15).margin(0.02));  // what the environment takes
  CHECK(bench.valid(kImu));
  CHECK(bench.changes(kImu) == 1);
  bench.check_reports();
}

TEST_CASE("the heater is off 2 s after the last temperature, and works again with the part") {
  Bench bench(at(3 * kSecond, kSilent) + "," + at(8 * kSecond, kBack));
  bench.run_to(3 * kSecond);
  CHECK(bench.heater() > 0);
  bench.run_to(3 * kSecond + 2010 * kMs);
  CHECK(bench.heater() == 0);
  while (bench.board.now_ns() < 8 * kSecond) {
    bench.run_to(bench.board.now_ns() + 50 * kMs);
    CHECK(bench.heater() == 0);
  }
  bench.run_to(9 * kSecond);
  CHECK(bench.heater() > 0);
}

TEST_CASE("an impossible temperature turns the heater off by the next conversion, however cold it says to be") {
  const double impossible = GENERATE(-60.0, 90.0);
  Bench bench(at(3 * kSecond,
                 R"("part": "imu", "do": "heat", "temperature": )" + std::to_string(static_cast<int>(impossible))));
  bench.run_to(3 * kSecond);
  CHECK(bench.heater() > 0);
  bench.run_to(4300 * kMs);  // a conversion every 1.28 s
  while (bench.board.now_ns() < 9 * kSecond) {
    CHECK(bench.heater() == 0);
    bench.run_to(bench.board.now_ns() + 50 * kMs);
  }
  CHECK(bench.valid(kImu));
}

TEST_CASE("a compass that is silent or restarted is invalid within 25 ms, leaves its bus free, and is set up again") {
  Bench bench(at(1 * kSecond, R"("part": "compass", "do": "silent")") + "," +
              at(1500 * kMs, R"("part": "compass", "do": "silent", "on": false)") + "," +
              at(2 * kSecond, R"("part": "compass", "do": "power_cycle")"));
  bench.run_to(1 * kSecond);
  CHECK(bench.valid(kCompass));
  CHECK(static_cast<std::int32_t>(bench.board.word("field_seen")) == Approx(20'000).margin(300));
  CHECK(bench.board.chip().gpio('G').level(6));  // its reset is let go of
  const auto before = bench.board.bus("i2c3");
  bench.run_to(1025 * kMs);
  CHECK(!bench.valid(kCompass));
  bench.run_to(1500 * kMs);
  CHECK(bench.changes(kCompass) == 2);
  const auto after = bench.board.bus("i2c3");
  CHECK(after.errors - before.errors >= 45);  // asked every 10 ms, refused every time
  CHECK(after.errors - before.errors <= 50);
  CHECK(!bench.board.chip().i2c("i2c3")->line.sda_held());
  bench.run_to(1600 * kMs);
  CHECK(bench.valid(kCompass));
  bench.run_to(2025 * kMs);
  CHECK(!bench.valid(kCompass));
  bench.run_to(2150 * kMs);
  CHECK(bench.valid(kCompass));
  CHECK(static_cast<std::int32_t>(bench.board.word("field_seen")) == Approx(20'000).margin(300));
  CHECK(bench.changes(kCompass) == 5);
  CHECK(bench.changes(kImu) == 1);
  CHECK(bench.board.resets() == 0);
  bench.check_reports();
}

TEST_CASE("the compass's bus is clocked free, and its values are old only as long as the line is held") {
  Bench bench(at(1 * kSecond, R"("port": "i2c3", "do": "hold_sda", "clocks": 5)") + "," +
              at(2 * kSecond, R"("port": "i2c3", "do": "hold_sda")") + "," +
              at(2500 * kMs, R"("port": "i2c3", "do": "release_sda")"));
  bench.run_to(1100 * kMs);
  CHECK(!bench.board.chip().i2c("i2c3")->line.sda_held());
  CHECK(bench.valid(kCompass));
  bench.run_to(2050 * kMs);
  CHECK(!bench.valid(kCompass));
  bench.run_to(2500 * kMs);
  CHECK(!bench.valid(kCompass));
  bench.run_to(2700 * kMs);
  CHECK(bench.valid(kCompass));
  CHECK(bench.changes(kImu) == 1);
  CHECK(bench.board.resets() == 0);
}
