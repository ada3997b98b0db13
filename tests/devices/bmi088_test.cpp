// BMI088 and the attitude filter: bring-up on both chip selects, values, and a part that fails.
#include "finemote/devices/bmi088.hpp"

#include <cmath>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

constexpr Duration kAccelAge = 2 * kMillisecond;  // a period of 800 a second less 5 %, and the filter

/// One of the two chips: registers, and how many bytes without meaning come before the data of a read.
struct Chip : host::SpiPart {
  Chip(std::uint8_t id, std::size_t dummies) : id(id), dummies(dummies) { reset(); }
  void reset() {
    registers.fill(0);
    registers[0] = id;
  }
  Bytes exchange(const Bytes& bytes) override {
    Bytes out(bytes.size(), 0xFF);
    if (missing) return out;
    const std::uint8_t address = bytes[0] & 0x7F;
    if ((bytes[0] & 0x80) == 0) {
      registers[address] = bytes.at(1);
      written.push_back(bytes);
      return out;
    }
    if (!frozen) {
      const auto time = static_cast<std::uint32_t>(now() / 39063);
      for (int i = 0; i < 3; ++i) registers[0x18 + i] = static_cast<std::uint8_t>(time >> 8 * i);
    }
    for (std::size_t i = 1 + dummies; i < out.size(); ++i) out[i] = registers[address + i - 1 - dummies];
    return out;
  }
  void set(std::uint8_t address, int x, int y, int z) {
    int i = 0;
    for (const int value : {x, y, z}) {
      registers[address + i++] = static_cast<std::uint8_t>(value & 0xFF);
      registers[address + i++] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
    }
  }
  std::array<std::uint8_t, 128> registers{};
  std::vector<Bytes> written;
  std::uint8_t id;
  std::size_t dummies;
  bool missing = false, frozen = false;
};

struct Fixture {
  Fixture() {
    bench::reset();
    host::spi1.connect(0, accel);
    host::spi1.connect(1, gyro);
    level();
    bench::robot().start = [this] { bus.start(); };
    bench::robot().fast = [this] {
      bus.supervise();
      imu.update();
    };
  }
  void level() { accel.set(0x12, 0, 0, 32768 / 6); }
  Chip accel{0x1E, 1}, gyro{0x0F, 0};
  SpiSlot gyro_slot{bus, 1, 1}, accel_slot{bus, 0, 1};
  SpiSlot* const table[2] = {&accel_slot, &gyro_slot};
  SpiBus bus{ports::spi1, 10000000, table};
  Bmi088 imu{{}, nullptr, accel_slot, gyro_slot};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "both chips are reset and set up, then rates and acceleration come") {
  gyro.set(0x02, 1638, 0, -16384);
  bench::run(500 * kMillisecond);
  CHECK(accel.written == std::vector<Bytes>{{0x7E, 0xB6}, {0x7D, 0x04}, {0x7C, 0x00}, {0x40, 0xAB}, {0x41, 0x01}});
  CHECK(gyro.written ==
        std::vector<Bytes>{
            {0x14, 0xB6}, {0x0F, 0x00}, {0x10, 0x82}, {0x11, 0x00}, {0x16, 0x00}, {0x18, 0x01}, {0x15, 0x80}});
  CHECK(imu.state.valid);
  CHECK(imu.state.acceleration[2] == Approx(9.80665).epsilon(1e-3));
  CHECK(imu.state.rate[0] == Approx(1638 * 2000.0 / 32768 * 0.01745329).epsilon(1e-4));
  CHECK(imu.state.rate[2] == Approx(-1000 * 0.01745329).epsilon(1e-4));
  CHECK(now() - imu.state.origin == 10 * kMillisecond + kAccelAge);  // asked for, and how old it was then
}

TEST_CASE_METHOD(Fixture, "a setting that did not get through is made again before anything is valid") {
  bool is_blocked = false;
  for (Time at = 0; at < 400 * kMillisecond; at += kMillisecond) {
    bench::at(at, [&] {
      if (is_blocked || accel.written.size() != 3) return;  // the next one is ACC_CONF
      is_blocked = true;
      host::spi1.block(true);
      bench::at(now() + 30 * kMillisecond, [] { host::spi1.block(false); });
    });
  }
  bench::run(1 * kSecond);
  REQUIRE(is_blocked);
  CHECK(imu.state.valid);
  CHECK(accel.registers[0x40] == 0xAB);
}

TEST_CASE_METHOD(Fixture, "an attitude is valid once gravity was seen") {
  accel.set(0x12, 0, 0, 0);
  bench::at(600 * kMillisecond, [&] {
    CHECK_FALSE(imu.state.valid);
    level();
  });
  bench::at(620 * kMillisecond, [&] {
    CHECK(imu.state.valid);
    accel.set(0x12, 0, 0, 0);
  });
  bench::run(700 * kMillisecond);
  CHECK(imu.state.valid);
  CHECK(accel.written.size() == 5);  // it was set up once
}

TEST_CASE_METHOD(Fixture, "a missing part is never valid, and is found when it appears") {
  accel.missing = true;
  bench::at(900 * kMillisecond, [&] {
    CHECK_FALSE(imu.state.valid);
    accel.missing = false;
  });
  bench::run(2 * kSecond);
  CHECK(imu.state.valid);
}

TEST_CASE_METHOD(Fixture, "a part that stands still or goes away is invalid at the next update and set up again") {
  const int fault = GENERATE(0, 1, 2);
  bench::at(501 * kMillisecond, [&] {
    CHECK(imu.state.valid);
    accel.frozen = fault == 0;
    accel.missing = fault == 1;
    gyro.missing = fault == 2;
  });
  bench::at(521 * kMillisecond, [&] { CHECK_FALSE(imu.state.valid); });
  bench::at(900 * kMillisecond, [&] {
    CHECK_FALSE(imu.state.valid);
    accel.frozen = accel.missing = gyro.missing = false;
  });
  bench::run(2 * kSecond);
  CHECK(imu.state.valid);
  CHECK(accel.written.size() >= 9);
}

TEST_CASE_METHOD(Fixture,
                 "a part that lost its power is not valid before it is set up again, however slowly it is read") {
  const bool is_seen_missing = GENERATE(true, false);
  int updates = 0;
  bench::robot().fast = [this, &updates] {
    bus.supervise();
    if (++updates % 10 == 0) imu.update();  // every 50 ms
  };
  std::size_t written = 0;
  bool was_wrong = false;
  bench::at(5001 * kMillisecond, [&] {
    CHECK(imu.state.valid);
    accel.frozen = true;
    accel.reset();  // suspended: its time stands at 0
    accel.missing = gyro.missing = is_seen_missing;
    written = accel.written.size();
  });
  bench::at(5052 * kMillisecond, [&] { accel.missing = gyro.missing = false; });
  for (int ms = 5103; ms < 6500; ms += 10)  // what was read before is valid until then
    bench::at(ms * kMillisecond, [&] { was_wrong |= imu.state.valid && accel.written.size() < written + 5; });
  bench::at(5400 * kMillisecond, [&] {
    accel.frozen = false;
    level();
  });
  bench::run(8 * kSecond);
  CHECK_FALSE(was_wrong);
  CHECK(accel.written.size() >= written + 5);
  CHECK(imu.state.valid);
}

namespace {

/// The part on its heater: warms by a number of kelvin a second at full power, and loses to an environment of 25
/// degrees.
struct Warm : Fixture {
  Warm() {
    heater.start();
    bench::robot().fast = [this] {
      bus.supervise();
      live(0.005F);
      warm.update();
      warm.handle();
      heater.flush();
    };
  }
  void live(float dt) {
    const float share =
        host::imu_heater.writes.empty() ? 0 : static_cast<float>(host::imu_heater.writes.back().pulse) / 1'000'000.0F;
    celsius += dt * (3 * share - 0.02F * (celsius - 25));
    if (sensor_dead) return;
    const int code = static_cast<int>(std::lround((celsius - 23) / 0.125F)) * 32;
    accel.registers[0x22] = static_cast<std::uint8_t>(code >> 8 & 0xFF);
    accel.registers[0x23] = static_cast<std::uint8_t>(code & 0xFF);
  }
  PwmBus heater{ports::imu_heater, 1'000'000};
  PwmChannel channel{heater, 0};
  Bmi088 warm{{}, nullptr, accel_slot, gyro_slot, &channel};
  float celsius = 25;
  bool sensor_dead = false;
};

}  // namespace

TEST_CASE_METHOD(Warm, "the heater brings the part to its temperature and holds it there") {
  float hottest = 0;
  for (int i = 1; i < 1200; ++i) bench::at(i * 100 * kMillisecond, [&] { hottest = std::max(hottest, celsius); });
  bench::run(120 * kSecond);
  CHECK(warm.temperature() == Approx(40).margin(0.5));
  CHECK(celsius == Approx(40).margin(0.5));
  CHECK(hottest < 44);
  CHECK(warm.heat() == Approx(0.1).margin(0.03));  // what the environment takes
}

TEST_CASE_METHOD(Warm, "the heater is off without a new or with an impossible temperature, and when made safe") {
  const int fault = GENERATE(0, 1, 2);
  bench::at(5 * kSecond, [&] {
    CHECK(host::imu_heater.writes.back().pulse > 0);
    if (fault == 0) accel.missing = true;
    if (fault == 1) sensor_dead = true;
    if (fault == 1) accel.registers[0x22] = 0x7F;
    if (fault == 2) bench::robot().fast = nullptr;
    if (fault == 2) warm.safe();
    if (fault == 2) heater.flush();
  });
  bench::run(8 * kSecond);
  CHECK(host::imu_heater.writes.back().pulse == 0);
  CHECK(warm.heat() == 0);
}

TEST_CASE_METHOD(Fixture, "the origin is not later than the data-ready edge, and a line without edges is not valid") {
  EdgePin ready{ports::exti5};
  Bmi088 timed{{}, nullptr, accel_slot, gyro_slot, nullptr, &ready};
  bool edges = true;
  for (int i = 0; i < 250; ++i) {  // a quarter of what there are
    bench::at((4 * i + 3) * kMillisecond + 300 * kMicrosecond, [&] {
      if (edges) host::exti5.edge();
    });
  }
  bench::robot().fast = [&] {
    bus.supervise();
    timed.update();
  };
  bench::at(501 * kMillisecond, [&] {
    CHECK(timed.state.valid);
    CHECK(timed.state.origin == 491'300 * kMicrosecond);  // the edge before the read that began at 495 ms
    edges = false;
  });
  bench::run(530 * kMillisecond);
  CHECK_FALSE(timed.state.valid);
}

TEST_CASE("the filter takes roll and pitch from gravity at once") {
  AttitudeFilter filter;
  const float rate[3] = {};
  const float tilted[3] = {-9.81F * std::sin(0.3F), 9.81F * std::sin(0.4F) * std::cos(0.3F),
                           9.81F * std::cos(0.4F) * std::cos(0.3F)};
  filter.step({}, rate, tilted, 0.001F);
  CHECK(filter.roll() == Approx(0.4).margin(1e-3));
  CHECK(filter.pitch() == Approx(0.3).margin(1e-3));
  CHECK(filter.yaw() == Approx(0).margin(1e-3));
}

TEST_CASE("the filter integrates turns about every axis and forgets a wrong start") {
  const float level[3] = {0, 0, 9.81F};
  for (int axis = 0; axis < 3; ++axis) {
    AttitudeFilter filter;
    float rate[3] = {};
    filter.step({0, 0}, rate, level, 0.001F);
    rate[axis] = 1;
    for (int i = 0; i < 500; ++i) filter.step({0, 0}, rate, level, 0.001F);
    const float angles[3] = {filter.roll(), filter.pitch(), filter.yaw()};
    for (int other = 0; other < 3; ++other) CHECK(angles[other] == Approx(other == axis ? 0.5 : 0).margin(2e-3));
    rate[axis] = 0;
    for (int i = 0; i < 20000; ++i) filter.step({0.5F, 0.0F}, rate, level, 0.001F);
    CHECK(filter.roll() == Approx(0).margin(2e-3));
    CHECK(filter.pitch() == Approx(0).margin(2e-3));
  }
}

TEST_CASE("the filter learns a gyroscope's offset") {
  AttitudeFilter filter;
  const float rate[3] = {0.02F, -0.01F, 0};
  const float level[3] = {0, 0, 9.81F};
  for (int i = 0; i < 200000; ++i) filter.step({1, 0.1F}, rate, level, 0.001F);
  CHECK(filter.offset()[0] == Approx(-0.02).margin(1e-3));
  CHECK(filter.offset()[1] == Approx(0.01).margin(1e-3));
  CHECK(filter.roll() == Approx(0).margin(1e-3));
}

TEST_CASE("free fall and hard knocks do not turn the attitude") {
  AttitudeFilter filter;
  const float rate[3] = {};
  const float level[3] = {0, 0, 9.81F}, knock[3] = {50, 0, 0}, none[3] = {};
  filter.step({}, rate, level, 0.001F);
  for (int i = 0; i < 1000; ++i) filter.step({10, 0}, rate, i % 2 == 0 ? knock : none, 0.001F);
  CHECK(filter.pitch() == Approx(0).margin(1e-4));
}

TEST_CASE_METHOD(Fixture, "rates, acceleration and attitude are those of the robot, however the part is mounted") {
  // On its left side, looking back: its x is the robot's -x, its y the robot's z, its z the robot's y.
  constexpr Rotation mount{{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
  Bmi088 turned{{}, &mount, accel_slot, gyro_slot};
  bench::robot().fast = [&] {
    bus.supervise();
    turned.update();
  };
  accel.set(0x12, 0, 32768 / 6, 0);
  gyro.set(0x02, 0, 0, 0);
  bench::run(600 * kMillisecond);
  REQUIRE(turned.state.valid);
  CHECK(turned.state.acceleration[2] == Approx(9.80665).epsilon(1e-3));
  CHECK(turned.state.roll == Approx(0).margin(0.01));
  CHECK(turned.state.pitch == Approx(0).margin(0.01));
  gyro.set(0x02, 0, 1638, 0);
  bench::at(700 * kMillisecond, [&] {
    CHECK(turned.state.rate[2] == Approx(1638 * 2000.0 / 32768 * 0.01745329).epsilon(1e-4));
    CHECK(turned.state.yaw > 0.1F);
  });
  bench::run(800 * kMillisecond);
}
