// Sensors that sample on a clock of their own: where their edges and samples are, and who moves that clock.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.hpp"
#include "emulator/parts/bmi088.hpp"
#include "emulator/parts/ist8310.hpp"
#include "emulator/parts/own_clock.hpp"
#include "emulator/scenario/grammar.hpp"
#include "generator/run/phase.hpp"

using namespace finemote::emulator;
namespace gen = finemote::gen;
using Json = nlohmann::ordered_json;

namespace {

constexpr Time kMs = from_ns(1'000'000);

struct Clock {
  Time phase;
  double ppm;
};
const Clock kClocks[] = {{0, 0}, {from_ns(300'000), 50'000}, {from_ns(71'700'000), -50'000}, {from_ns(1), 123.4}};

/// The first instant of a part's samples at or after a time of the board, by real numbers.
double next_sample(const Clock& clock, double period, double at) {
  const double own = period / (1 + clock.ppm * 1e-6), phase = static_cast<double>(clock.phase);
  return phase + std::ceil((at - phase) / own - 1e-6) * own;
}

/// A board's time that jumps from event to event, and a part's clock beside it.
struct Bench {
  explicit Bench(const Clock& given) : clock(board, given.phase, given.ppm) {}
  void run(Time until) {
    while (queue.next() <= until) {
      now = queue.next();
      queue.run(now);
    }
    now = until;
  }
  Time now = 0;
  EventQueue queue;
  PartClock board{[this] { return now; },
                  [this](Time at, EventQueue::Action action) { queue.at(at, std::move(action)); }};
  OwnClock clock;
};

std::vector<std::uint8_t> exchange(SpiPart& chip, const std::vector<int>& bytes) {
  std::vector<std::uint8_t> answer;
  chip.select(true);
  for (const int byte : bytes) answer.push_back(chip.exchange(static_cast<std::uint8_t>(byte)));
  chip.select(false);
  return answer;
}

/// An inertial sensor at 1000 Hz (rates) and 800 Hz, whose data-ready edges are noted.
struct Inertial : Bench {
  explicit Inertial(const Clock& given) : Bench(given) {
    part.on_output = [this](Bmi088::Output which, int level) {
      if (which == Bmi088::Output::int3 && level == 0) edges.push_back(now);
    };
    part.on_sample = [this](Bmi088::Quantity quantity, Time from) {
      taken[quantity] = clock.board(from);
      return Tag{1};
    };
    run(40 * kMs);
    exchange(accelerometer, {0x80, 0, 0});  // the first select turns it to SPI
    set(accelerometer, {{0x7D, 0x04}, {0x7C, 0x00}, {0x40, 0xAB}});
    set(gyroscope, {{0x10, 0x82}, {0x16, 0x00}, {0x18, 0x01}, {0x15, 0x80}});
    edges.clear();
  }
  static void set(SpiPart& chip, const std::vector<std::pair<int, int>>& settings) {
    for (const auto& [address, value] : settings) exchange(chip, {address, value});
  }
  void read() {
    exchange(accelerometer, {0x92, 0, 0, 0, 0, 0, 0, 0});
    exchange(gyroscope, {0x82, 0, 0, 0, 0, 0, 0});
  }
  Bmi088 part{clock.part_clock(), [](Time) { return Motion{}; }, [](Time) { return 25; }};
  SpiPart accelerometer = part.accelerometer(), gyroscope = part.gyroscope();
  std::vector<Time> edges;                 ///< by the board's clock
  std::map<Bmi088::Quantity, Time> taken;  ///< by the board's clock
};

/// Entries of a robot's parts with the clocks that a phase draws.
Json drawn(std::uint64_t number, const std::map<std::string, double>& declared = {}) {
  Json parts = Json::parse(R"([
    {"type": "h30_imu", "name": "h30"}, {"type": "bmi088", "name": "imu"}, {"type": "ist8310", "name": "compass"},
    {"type": "ms5837", "name": "depth"}])");
  gen::shift_clocks({7, number}, 0, declared, parts);
  return parts;
}

}  // namespace

TEST_CASE("a clock without phase and error is the board's") {
  const Bench bench({0, 0});
  for (const Time at : {Time{0}, Time{1}, 17 * kMs + 5, 86'400'000 * kMs}) {
    CHECK(bench.clock.own(at) == at);
    CHECK(bench.clock.board(at) == at);
  }
}

TEST_CASE("a part's clock counts at its rate from its phase on, and comes back to the same time") {
  for (const Clock& given : kClocks) {
    INFO(given.phase << " steps, " << given.ppm << " ppm");
    const OwnClock clock = Bench(given).clock;
    CHECK(clock.own(given.phase) % OwnClock::kGrid == 0);
    for (const Time at : {Time{0}, Time{12'345'678'901}, 100'000 * kMs + 7}) {
      const double passed = static_cast<double>(at) * (1 + given.ppm * 1e-6);
      CHECK(static_cast<double>(clock.own(at) - clock.own(0)) == Approx(passed).margin(2).epsilon(1e-12));
    }
    for (Time own = clock.own(kMs); own < clock.own(kMs) + 100; ++own) {  // the first time at which it counts that
      CHECK(clock.own(clock.board(own)) >= own);
      CHECK(clock.own(clock.board(own) - 1) < own);
    }
  }
}

TEST_CASE("edges and samples of the inertial sensor are at its phase and rate, by the board's clock") {
  for (const Clock& given : kClocks) {
    INFO(given.phase << " steps, " << given.ppm << " ppm");
    Inertial sensor(given);
    for (Time end = 50 * kMs; end < 150 * kMs; end += 3 * kMs + 7'001) {
      sensor.run(end);
      sensor.read();
      CHECK(sensor.taken[Bmi088::Quantity::rates] == sensor.edges.back());
      const auto acceleration = static_cast<double>(sensor.taken[Bmi088::Quantity::acceleration]);
      constexpr double kPeriod = 1.25 * static_cast<double>(kMs);
      CHECK(acceleration == Approx(next_sample(given, kPeriod, acceleration)).margin(2).epsilon(0));
      CHECK(sensor.taken[Bmi088::Quantity::acceleration] <= end);
      CHECK(static_cast<double>(end) < acceleration + kPeriod / (1 + given.ppm * 1e-6) + 2);
    }
    REQUIRE(sensor.edges.size() > 90);
    double expected = next_sample(given, static_cast<double>(kMs), 40.01 * static_cast<double>(kMs));
    for (const Time edge : sensor.edges) {
      CHECK(static_cast<double>(edge) == Approx(expected).margin(2).epsilon(0));
      expected += static_cast<double>(kMs) / (1 + given.ppm * 1e-6);
    }
  }
}

TEST_CASE("the compass measures by itself at its phase and rate, by the board's clock") {
  for (const Clock& given : kClocks) {
    INFO(given.phase << " steps, " << given.ppm << " ppm");
    Bench bench(given);
    Ist8310 part(0x0E, bench.clock.part_clock(), [](Time) { return Eigen::Vector3d(30e-6, 0, 0); });
    std::vector<Time> taken, ready;
    part.on_read = [&](Time from) {
      taken.push_back(bench.clock.board(from));
      return Tag{1};
    };
    part.on_ready = [&](int level) {
      if (level == 0) ready.push_back(bench.now);
    };
    I2cLine line;
    line.attach(part);
    const auto write = [&](std::initializer_list<int> bytes) {
      line.select(0x0E, false);
      for (const int byte : bytes) line.write(static_cast<std::uint8_t>(byte));
      line.stop();
    };
    bench.run(20 * kMs + kMs / 2);
    write({0x0B, 0x08});  // CNTL2: data ready on its pin, active low
    write({0x0A, 0x0B});  // CNTL1: by itself
    ready.clear();
    double expected = next_sample(given, 5.0 * static_cast<double>(kMs), static_cast<double>(bench.now));
    for (int i = 0; i < 20; ++i, expected += 5.0 * static_cast<double>(kMs) / (1 + given.ppm * 1e-6)) {
      bench.run(static_cast<Time>(expected) + kMs);
      REQUIRE(ready.size() == static_cast<std::size_t>(i) + 1);
      CHECK(static_cast<double>(ready.back()) == Approx(expected).margin(2).epsilon(0));
      write({0x03});
      line.select(0x0E, true);
      line.read();
      line.stop();
      CHECK(taken.back() == ready.back());
    }
  }
}

TEST_CASE("phases give the inertial sensor and the compass clocks of their own") {
  std::set<double> rates, phases;
  for (std::uint64_t number = 0; number < 40; ++number) {
    const Json parts = drawn(number);
    CHECK(!parts[3].contains("clock_ppm"));  // it samples when it is asked to
    for (const std::size_t i : {1U, 2U}) {
      const double most = i == 1 ? 50'000 : 8'000;  // the data sheet's; of a resonator
      const double ppm = parts[i].at("clock_ppm");
      CHECK(std::abs(ppm) <= most + 1e-6);
      CHECK(parts[i].at("phase_ns").get<double>() < 80e6);
      if (i == 1) rates.insert(std::round(ppm));
      phases.insert(parts[i].at("phase_ns").get<double>());
    }
  }
  CHECK(rates.count(50'000) == 1);
  CHECK(rates.count(-50'000) == 1);
  CHECK(rates.size() > 10);
  CHECK(phases.size() > 30);
  CHECK(drawn(3) == drawn(3));
  const Json tamed = drawn(3, {{"imu", 400}, {"compass", 100}});
  CHECK(std::abs(tamed[1].at("clock_ppm").get<double>()) <= 400 + 1e-6);
  CHECK(std::abs(tamed[2].at("clock_ppm").get<double>()) <= 100 + 1e-6);
}
