// MS5837: the data sheets' arithmetic, the bytes on the wire, and what becomes of a part that fails.
#include "finemote/devices/ms5837.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "runtime/boards/host/ports/i2c_parts.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;
using Variant = Ms5837::Variant;

constexpr Ms5837::Calibration kWide{{0, 34982, 36352, 20328, 22354, 26646, 26146}};
constexpr Ms5837::Calibration kNarrow{{0, 46372, 43981, 29059, 27842, 31553, 28165}};
constexpr Ms5837::Calibration kLargest{{0, 65535, 65535, 65535, 65535, 65535, 65535}};

struct Vector {
  Variant variant;
  const Ms5837::Calibration& calibration;
  std::uint32_t d1, d2;
  std::int32_t temperature, pressure;
};

struct Fixture {
  explicit Fixture(Ms5837::Config config = {}) : part(config.variant), sensor(config, slot) {
    bench::reset();
    mux.connect(0, 0x76, part);
    host::i2c2.connect(0x70, mux);
    bench::robot().start = [this] { bus.start(); };
    bench::robot().fast = [this] { bus.supervise(); };
    bench::robot().slow = [this] { sensor.update(); };
  }
  host::Tca9548aPart mux;
  host::Ms5837Part part;
  I2cSlot slot{bus, 0x76, {0x70, 0x01}, 1};
  I2cSlot* const table[1] = {&slot};
  I2cBus bus{ports::i2c2, 400000, table};
  Ms5837 sensor;
};

}  // namespace

// The first of each variant is the data sheet's example; the others were computed by hand with unbounded integers.
TEST_CASE("compensation of both variants in every branch") {
  const Vector vectors[] = {
      {Variant::k30BA, kWide, 4958179, 6815414, 1981, 39998},
      {Variant::k30BA, kWide, 4958179, 7815414, 5084, 41670},   // above 20 degrees
      {Variant::k30BA, kWide, 5500000, 5700000, -1935, 71351},  // below 20
      {Variant::k30BA, kWide, 4958179, 5600000, -2327, 38066},  // below -15
      {Variant::k02BA, kNarrow, 6465444, 8077636, 2000, 110002},
      {Variant::k02BA, kNarrow, 6465444, 7500000, -46, 105081},  // below 20
      {Variant::k02BA, kNarrow, 6465444, 8500000, 3418, 113417},
      // Words nobody would calibrate, but 64 bits hold them.
      {Variant::k30BA, kLargest, 0xFFFFFF, 0xFFFFFF, 2001, 1572887},
      {Variant::k30BA, kLargest, 0xFFFFFF, 1, -227368, -58575441},
      {Variant::k02BA, kLargest, 0xFFFFFF, 1, -219177, -7011936},
  };
  for (const Vector& v : vectors) {
    INFO(v.d1 << " " << v.d2);
    const Ms5837::Compensated result = Ms5837::compensate(v.variant, v.calibration, v.d1, v.d2);
    CHECK(result.temperature == v.temperature);
    CHECK(result.pressure == v.pressure);
  }
}

TEST_CASE("the CRC covers every bit of the words, but not its own four") {
  CHECK(Ms5837::crc4(kWide) == 2);
  CHECK(Ms5837::crc4(kNarrow) == 8);
  Ms5837::Calibration changed = kWide;
  changed.c[0] |= 0xF000;
  CHECK(Ms5837::crc4(changed) == 2);
  for (unsigned word = 1; word < 7; ++word) {
    for (unsigned bit = 0; bit < 16; ++bit) {
      changed = kWide;
      changed.c[word] = static_cast<std::uint16_t>(changed.c[word] ^ 1U << bit);
      CHECK(Ms5837::crc4(changed) != 2);
    }
  }
}

TEST_CASE_METHOD(Fixture, "commands: reset, PROM, a temperature, then pressures") {
  bench::run(200 * kMillisecond);
  std::vector<Bytes> sent;
  for (const host::I2cExchange& exchange : host::i2c2.exchanges) {
    if (exchange.address == 0x76) sent.push_back(exchange.written);
  }
  REQUIRE(sent.size() > 16);
  sent.resize(16);
  CHECK(sent == std::vector<Bytes>{{0x1E},
                                   {0xA0},
                                   {0xA2},
                                   {0xA4},
                                   {0xA6},
                                   {0xA8},
                                   {0xAA},
                                   {0xAC},
                                   {0x54},  // temperature, OSR 1024
                                   {0x00},
                                   {0x44},
                                   {0x00},
                                   {0x44},
                                   {0x00},
                                   {0x44},
                                   {0x00}});
}

TEST_CASE_METHOD(Fixture, "the state follows the water, with the begin of the conversion as origin") {
  part.set(150000, 12.5);
  Time valid_at = 0;
  Duration oldest_age = 0;
  bench::robot().slow = [&] {
    sensor.update();
    if (!sensor.state.valid) return;
    if (valid_at == 0) valid_at = now();
    oldest_age = std::max(oldest_age, now() - sensor.state.origin);
  };
  bench::run(2 * kSecond);
  CHECK(sensor.state.valid);
  CHECK(sensor.state.pressure == Approx(150000).margin(10));
  CHECK(sensor.state.temperature == Approx(12.5).margin(0.02));
  CHECK(valid_at <= 150 * kMillisecond);
  // Two periods as a rule, four around a temperature: the descriptor's acquisition says at most (2 + 1) * 10 ms.
  CHECK(oldest_age <= 30 * kMillisecond);
  CHECK(oldest_age >= 20 * kMillisecond - kMillisecond);
}

TEST_CASE("a conversion longer than the period is waited for in whole periods") {
  Fixture f{{Variant::k30BA, 8192}};
  f.part.set(120000, 20);
  bench::run(2 * kSecond);
  CHECK(f.sensor.state.valid);
  CHECK(f.sensor.state.pressure == Approx(120000).margin(10));
}

TEST_CASE("the 2 bar part has its own arithmetic") {
  Fixture f{{Variant::k02BA, 256}};
  f.part.set(103456, 15);
  bench::run(1 * kSecond);
  CHECK(f.sensor.state.valid);
  CHECK(f.sensor.state.pressure == Approx(103456).margin(2));
  CHECK(f.sensor.state.temperature == Approx(15).margin(0.02));
}

TEST_CASE_METHOD(Fixture, "a wrong PROM never becomes a pressure") {
  part.bad_prom = true;
  bool ever = false;
  bench::robot().slow = [&] {
    sensor.update();
    ever = ever || sensor.state.valid;
  };
  bench::run(2 * kSecond);
  CHECK_FALSE(ever);
}

TEST_CASE_METHOD(Fixture, "a part that falls silent is invalid and stays old for a minute, then comes back") {
  Time origin = 0;
  bench::at(500 * kMillisecond, [&] {
    CHECK(sensor.state.valid);
    part.silent = true;
  });
  bench::at(600 * kMillisecond, [&] {
    CHECK_FALSE(sensor.state.valid);
    origin = sensor.state.origin;
  });
  bench::at(60 * kSecond, [&] {
    CHECK_FALSE(sensor.state.valid);
    CHECK(sensor.state.origin == origin);
    CHECK(origin <= 500 * kMillisecond);
    part.silent = false;
  });
  bench::run(61 * kSecond);
  CHECK(sensor.state.valid);
  CHECK(bus.counters().recoveries == 0);
}

TEST_CASE_METHOD(Fixture, "one refused transfer costs some periods, not the bring-up") {
  bench::at(500 * kMillisecond + 1, [&] { host::i2c2.refuse(1); });
  bench::at(515 * kMillisecond, [&] { CHECK_FALSE(sensor.state.valid); });
  bench::at(550 * kMillisecond, [&] { CHECK(sensor.state.valid); });
  bench::run(600 * kMillisecond);
}

TEST_CASE_METHOD(Fixture, "a part that was reset in flight gives no wrong pressure and comes back") {
  part.set(150000, 20);
  bool wrong = false;
  bench::robot().slow = [&] {
    sensor.update();
    wrong = wrong || (sensor.state.valid && std::abs(sensor.state.pressure - 150000) > 20);
  };
  for (int i = 0; i < 20; ++i) bench::at(500 * kMillisecond + i * 10300 * kMicrosecond, [&] { part.reset(); });
  bench::run(2 * kSecond);
  CHECK_FALSE(wrong);
  CHECK(sensor.state.valid);
}

TEST_CASE_METHOD(Fixture, "values no water has are invalid, and lead to a new bring-up") {
  bench::at(500 * kMillisecond, [&] { part.noise = 0xC00000; });
  bench::at(700 * kMillisecond, [&] { CHECK_FALSE(sensor.state.valid); });
  bench::at(900 * kMillisecond, [&] {
    CHECK_FALSE(sensor.state.valid);
    part.noise = 0;
  });
  bench::run(1200 * kMillisecond);
  CHECK(sensor.state.valid);
}
