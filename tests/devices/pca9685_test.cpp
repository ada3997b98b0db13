// PCA9685: bytes of the bring-up and of every burst, and what the part shows.
#include "finemote/pca9685.hpp"

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "finemote/devices/pwm_esc.hpp"
#include "finemote/devices/pwm_servo.hpp"
#include "runtime/boards/host/ports/i2c_parts.hpp"
#include "runtime/src/start.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

struct Fixture {
  Fixture() {
    bench::reset();
    host::i2c2.connect(0x40, part);
    bench::robot().start = [this] { bus.start(); };
    bench::robot().fast = [this] { bus.supervise(); };
    bench::robot().slow = [this] { pwm.flush(); };
  }
  /// Everything written since the last call, addresses left out.
  std::vector<Bytes> written() {
    std::vector<Bytes> all;
    for (; seen < host::i2c2.exchanges.size(); ++seen) all.push_back(host::i2c2.exchanges[seen].written);
    return all;
  }
  void safe(std::initializer_list<unsigned> channels) {
    for (const unsigned n : channels) {
      pwm.set_safe(static_cast<std::uint8_t>(n), 1500000);
      pwm.set(static_cast<std::uint8_t>(n), 1500000);
    }
  }
  void pass(Duration duration) { host::advance(duration); }

  host::Pca9685Part part;
  I2cSlot slot{bus, 0x40, {}, 1};
  I2cSlot* const table[1] = {&slot};
  I2cBus bus{ports::i2c2, 400000, table};
  Pca9685 pwm{slot, {50, 25000000, 50}};
  std::size_t seen = 0;
};

}  // namespace

TEST_CASE("prescale and counts follow the data sheet") {
  CHECK(Pca9685::prescale({50, 25000000, 50}) == 121);
  CHECK(Pca9685::prescale({200, 25000000, 50}) == 30);
  CHECK(Pca9685::prescale({1526, 25000000, 50}) == 3);
  CHECK(Pca9685::prescale({24, 25000000, 50}) == 253);
  I2cBus bus{ports::i2c2, 400000};
  I2cSlot slot{bus, 0x40, {}, 1};
  const Pca9685 pwm{slot};
  // One count is (121 + 1) / 25 MHz = 4880 ns.
  CHECK(pwm.counts(1500000) == 307);  // 307.38
  CHECK(pwm.counts(1100000) == 225);  // 225.41
  CHECK(pwm.counts(1900000) == 389);  // 389.34
  CHECK(pwm.counts(4880 * 1000) == 1000);
  CHECK(pwm.counts(25000000) == 4095);
}

TEST_CASE_METHOD(Fixture, "bring-up: safe pulses first, then mode, prescale, wake, restart, safe pulses again") {
  bench::robot().safe = [&] {
    safe({0, 1});
    pwm.flush();
  };
  bench::run(200 * kMillisecond);
  const Bytes neutral{0x06, 0, 0, 0x33, 0x01, 0, 0, 0x33, 0x01};  // OFF = 307
  CHECK(written() ==
        std::vector<Bytes>{
            neutral, {0x00}, {0xFE}, {0x00, 0x30}, {0xFE, 0x79}, {0x00, 0x20}, {0x00, 0xA0}, neutral, neutral});
  CHECK(part.pulse(0) == 307 * 4880);
  CHECK(part.pulse(1) == 307 * 4880);
  CHECK(part.pulse(2) == 0);
  CHECK(part.reg(0xFE) == 121);
  CHECK(pwm.running());
}

TEST_CASE_METHOD(Fixture, "a part that runs with the right prescale is not put to sleep") {
  part.write({0x00, 0x20});
  part.write({0x00, 0x30});
  part.write({0xFE, 121});
  part.write({0x00, 0x20});
  part.write({0x06, 0, 0, 0x85, 0x01});  // full ahead, left over from before our reset
  bench::robot().safe = [&] {
    safe({0});
    pwm.flush();
  };
  const std::size_t before = part.changes.size();
  bench::run(100 * kMillisecond);
  CHECK(written() == std::vector<Bytes>{{0x06, 0, 0, 0x33, 0x01}, {0x00}, {0xFE}, {0x06, 0, 0, 0x33, 0x01}});
  CHECK(part.changes[before].pulses[0] == 307 * 4880);  // the very first write stops it
  CHECK(part.changes[before].at < 1 * kMillisecond);
}

TEST_CASE_METHOD(Fixture, "no pulse is sent as any other: a part that outlived our reset may show one") {
  part.write({0x00, 0x20});
  part.write({0xFE, 121});
  part.write({0x12, 0, 0, 0x85, 0x01});
  PwmServo servo{{500000, 2500000, 3.14159265F, false, 500000000, PwmServo::OnLoss::kRelease}, {pwm, 3}};
  SECTION("where a job tells the servo that it has no command") {
    bench::robot().slow = [&] {
      servo.handle();
      pwm.flush();
    };
  }
  SECTION("where the robot stops before its first job") {
    bench::robot().safe = [&] {
      servo.safe();
      pwm.flush();
    };
    bench::robot().slow = [this] { pwm.flush(); };
  }
  bench::run(100 * kMillisecond);
  CHECK(part.pulse(3) == 0);
  CHECK(written().front() == Bytes{0x12, 0, 0, 0, 0x10});  // full off, before anything else
}

TEST_CASE_METHOD(Fixture, "one burst from the first to the last changed channel; nothing when nothing changed") {
  bench::robot().safe = [&] {
    safe({0, 1, 2, 3, 4, 5, 6, 7});
    pwm.flush();
  };
  bench::run(200 * kMillisecond);
  written();

  bench::robot().slow = nullptr;
  pwm.flush();
  pass(5 * kMillisecond);
  CHECK(written().empty());

  pwm.set(2, 1100000);
  pwm.set(4, 1900000);
  pwm.flush();
  pass(5 * kMillisecond);
  CHECK(written() == std::vector<Bytes>{{0x0E, 0, 0, 0xE1, 0x00, 0, 0, 0x33, 0x01, 0, 0, 0x85, 0x01}});

  pwm.set(2, 1100000);  // the same again
  pwm.flush();
  pass(5 * kMillisecond);
  CHECK(written().empty());

  for (std::uint8_t n = 0; n < 8; ++n) pwm.set(n, 1200000U + n);
  pwm.flush();
  pass(5 * kMillisecond);
  const auto burst = written();
  REQUIRE(burst.size() == 1);
  CHECK(burst[0].size() == 33);

  pwm.set(15, 0);  // the first time
  pwm.flush();
  pass(5 * kMillisecond);
  CHECK(written() == std::vector<Bytes>{{0x42, 0, 0, 0, 0x10}});

  pwm.set(15, 0);
  pwm.set(0, 0);  // no pulse: full off
  pwm.flush();
  pass(5 * kMillisecond);
  CHECK(written() == std::vector<Bytes>{{0x06, 0, 0, 0, 0x10}});
  CHECK(part.pulse(0) == 0);
}

TEST_CASE_METHOD(Fixture, "a change while a burst is under way waits for the next flush and is not lost") {
  bench::robot().safe = [&] { safe({0}); };
  bench::run(200 * kMillisecond);
  written();
  bench::robot().slow = nullptr;
  pwm.set(0, 1100000);
  pwm.flush();
  pwm.set(0, 1900000);
  pwm.flush();
  pass(2 * kMillisecond);
  CHECK(part.pulse(0) == 225 * 4880);
  pwm.flush();
  pass(2 * kMillisecond);
  CHECK(part.pulse(0) == 389 * 4880);
}

TEST_CASE_METHOD(Fixture, "every refresh reads MODE1 back and writes all used channels, in one unit") {
  bench::robot().safe = [&] { safe({3}); };
  bench::run(200 * kMillisecond);
  written();
  bench::robot().slow = nullptr;
  std::vector<Bytes> all;
  for (int i = 0; i < 50; ++i) {
    pwm.flush();
    pass(2 * kMillisecond);
    for (const Bytes& bytes : written()) all.push_back(bytes);
  }
  CHECK(all == std::vector<Bytes>{{0x00}, {0x12, 0, 0, 0x33, 0x01}});
}

TEST_CASE_METHOD(Fixture, "a part whose power failed is brought up again, safe pulses first") {
  bench::robot().safe = [&] { safe({0}); };
  bench::at(300 * kMillisecond, [&] { pwm.set(0, 1900000); });
  std::size_t before = 0;
  bench::at(400 * kMillisecond, [&] {
    CHECK(part.pulse(0) == 389 * 4880);
    part.reset();
    before = part.changes.size();
  });
  bench::run(1500 * kMillisecond);
  CHECK(part.pulse(0) == 389 * 4880);  // still wanted
  CHECK(part.reg(0xFE) == 121);
  bool neutral_seen = false;
  for (std::size_t i = before; i < part.changes.size(); ++i) {
    const std::uint32_t pulse = part.changes[i].pulses[0];
    if (pulse == 307 * 4880) neutral_seen = true;
    if (pulse != 0 && !neutral_seen) CHECK(pulse == 307 * 4880);
  }
  CHECK(neutral_seen);
}

TEST_CASE_METHOD(Fixture, "a part that does not answer is unreachable, and comes back by the whole bring-up") {
  bench::robot().safe = [&] { safe({0}); };
  bench::at(200 * kMillisecond, [&] { part.silent = true; });
  bench::at(400 * kMillisecond, [&] {
    pwm.set(0, 1900000);
    part.reset();
  });
  bench::at(500 * kMillisecond, [&] {
    CHECK(pwm.unreachable());
    CHECK_FALSE(pwm.running());
    part.silent = false;
  });
  bench::run(1 * kSecond);
  CHECK_FALSE(pwm.unreachable());
  CHECK(pwm.running());
  CHECK(part.pulse(0) == 389 * 4880);
}

TEST_CASE_METHOD(Fixture, "after a stuck bus the first bytes are the safe pulses, then what is wanted") {
  bench::robot().safe = [&] { safe({0, 1}); };
  bench::at(200 * kMillisecond, [&] {
    pwm.set(0, 1900000);
    pwm.set(1, 1900000);
  });
  bench::at(301 * kMillisecond, [&] {
    host::i2c2.hold_sda(5);
    pwm.set(0, 1100000);
  });
  std::size_t before = 0;
  bench::at(302 * kMillisecond, [&] { before = part.changes.size(); });
  bench::run(600 * kMillisecond);
  REQUIRE(part.changes.size() > before + 1);
  CHECK(part.changes[before].pulses[0] == 307 * 4880);
  CHECK(part.changes[before].pulses[1] == 307 * 4880);
  CHECK(part.changes[before].at < 350 * kMillisecond);
  CHECK(part.pulse(0) == 225 * 4880);
  CHECK(part.pulse(1) == 389 * 4880);
}

TEST_CASE_METHOD(Fixture, "an output without a safe pulse between two that have one keeps its own after a recovery") {
  bench::robot().safe = [&] { safe({0, 2}); };
  bench::at(300 * kMillisecond, [&] { pwm.set(1, 1900000); });
  std::size_t before = 0;
  bench::at(400 * kMillisecond, [&] {
    CHECK(part.pulse(1) == 389 * 4880);
    bench::robot().slow = [] {};  // no flush from here on
    host::i2c2.disturb(1);
    before = part.changes.size();
    slot.start(nullptr, 0);
  });
  bench::run(600 * kMillisecond);
  REQUIRE(part.changes.size() > before);
  for (std::size_t i = before; i < part.changes.size(); ++i) CHECK(part.changes[i].pulses[1] == 389 * 4880);
}

TEST_CASE_METHOD(Fixture, "a safe write that is on the wire does not change") {
  bench::robot().safe = [&] { safe({0, 2}); };
  bench::at(300 * kMillisecond, [&] { pwm.set(1, 1900000); });
  std::size_t before = 0;
  bench::at(400 * kMillisecond, [&] {
    bench::robot().slow = [] {};  // no flush but that below
    host::i2c2.disturb(1);
    before = part.changes.size();
    slot.start(nullptr, 0);
  });
  bool is_set = false;
  for (Time at = 400 * kMillisecond; at < 500 * kMillisecond; at += 50 * kMicrosecond) {
    bench::at(at, [&] {
      if (is_set || !slot.sends_safe()) return;
      is_set = true;
      pwm.set(1, 1100000);
      pwm.flush();
    });
  }
  bench::run(600 * kMillisecond);
  REQUIRE(is_set);
  REQUIRE(part.changes.size() > before);
  CHECK(part.changes[before].pulses[1] == 389 * 4880);
  CHECK(part.pulse(1) == 225 * 4880);
}

TEST_CASE_METHOD(Fixture,
                 "once the robot has stopped the safe write has what was set last for outputs between safe ones") {
  bench::robot().safe = [&] { safe({0, 2}); };
  bench::at(300 * kMillisecond, [&] { pwm.set(1, 1900000); });
  bench::run(400 * kMillisecond);
  REQUIRE(part.pulse(1) == 389 * 4880);
  detail::set_stopped(true);
  std::size_t before = 0;
  for (int i = 0; i < 20; ++i) {
    bus.supervise();  // as generated code does: the safe write is on the wire when the flush comes
    pwm.set(1, 1100000);
    pwm.flush();
    pass(5 * kMillisecond);
    if (i == 1) before = part.changes.size();
  }
  REQUIRE(part.changes.size() >= before + 10);
  for (std::size_t i = before; i < part.changes.size(); ++i) CHECK(part.changes[i].pulses[1] == 225 * 4880);
}

TEST_CASE_METHOD(Fixture, "a flush cut off by a stop of the robot does not keep the safe pulses back") {
  bench::robot().safe = [&] { safe({0}); };
  bench::run(200 * kMillisecond);
  pwm.set(0, 1900000);
  struct Stop {};
  host::i2c2.when_pended = [] { throw Stop{}; };
  CHECK_THROWS_AS(pwm.flush(), Stop);
  host::i2c2.when_pended = nullptr;
  bus.on_interrupt(I2cEvent::kNone);  // what was asked for goes out
  pass(5 * kMillisecond);
  safe({0});
  const auto flush = [&] {
    for (int i = 0; i < 100; ++i) {
      pwm.flush();
      pass(2 * kMillisecond);
    }
  };
  flush();
  CHECK(part.pulse(0) == 389 * 4880);  // it may go on, however often it is preempted
  detail::set_stopped(true);
  flush();
  CHECK(part.pulse(0) == 307 * 4880);
}
