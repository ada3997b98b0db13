// Speed controller: pulses, and neutral whenever the data do not deserve more.
#include "finemote/devices/pwm_esc.hpp"

#include <limits>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "runtime/src/start.hpp"

namespace {

using namespace finemote;

struct Fixture {
  Fixture() {
    bench::reset();
    bus.start();
    host::advance(1 * kSecond);
  }
  std::uint32_t drive(PwmEsc& esc, float effort, Duration age = 0, bool valid = true) {
    esc.command.effort = effort;
    esc.command.origin = now() - age;
    esc.command.valid = valid;
    esc.update();
    esc.handle();
    bus.flush();
    return host::pwm1.writes.empty() ? 0 : host::pwm1.writes.back().pulse;
  }
  PwmBus bus{ports::pwm1};
  PwmEsc esc{{}, {bus, 0}};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "efforts become pulses") {
  CHECK(host::pwm1.period == 20 * kMillisecond);
  CHECK(drive(esc, 0) == 1500000);
  CHECK(drive(esc, 1) == 1900000);
  CHECK(drive(esc, -1) == 1100000);
  CHECK(drive(esc, 0.5F) == 1700000);
  PwmEsc reversed{{1500000, 1100000, 1900000, true, 100000000, 0}, {bus, 0}};
  CHECK(drive(reversed, 1) == 1100000);
  CHECK(drive(reversed, 0) == 1500000);
  PwmEsc dead{{1610000, 1100000, 1900000, false, 100000000, 50000}, {bus, 0}};
  CHECK(drive(dead, 0) == 1610000);
  CHECK(drive(dead, 1) == 1900000);
  CHECK(drive(dead, 0.001F) == Approx(1660240).margin(2));
  CHECK(drive(dead, -0.001F) == Approx(1559540).margin(2));
}

TEST_CASE_METHOD(Fixture, "a dead zone wider than the range of pulses ends with it") {
  PwmEsc narrow{{1500000, 1480000, 1550000, false, 100000000, 200000}, {bus, 0}};
  for (const float effort : {0.01F, 0.3F, 1.0F}) {
    CHECK(drive(narrow, effort) == 1550000);
    CHECK(drive(narrow, -effort) == 1480000);
    CHECK(drive(narrow, 0) == 1500000);
  }
}

TEST_CASE_METHOD(Fixture, "old, invalid and impossible commands are neutral") {
  CHECK(drive(esc, 1, 100 * kMillisecond) == 1900000);
  CHECK(drive(esc, 1, 100 * kMillisecond + 1) == 1500000);
  CHECK(drive(esc, 1) == 1900000);
  CHECK(drive(esc, 1, 0, false) == 1500000);
  CHECK(drive(esc, 1) == 1900000);
  CHECK(drive(esc, 1.01F) == 1500000);
  CHECK(drive(esc, 1) == 1900000);
  CHECK(drive(esc, std::numeric_limits<float>::quiet_NaN()) == 1500000);
  CHECK(drive(esc, 1) == 1900000);
  CHECK(drive(esc, -std::numeric_limits<float>::infinity()) == 1500000);
}

TEST_CASE_METHOD(Fixture, "a parent that repeats old data does not keep it going") {
  const Time origin = now();
  for (int i = 0; i < 20; ++i) {
    const bool fresh = now() - origin <= 100 * kMillisecond;
    CHECK(drive(esc, 1, now() - origin) == (fresh ? 1900000 : 1500000));
    host::advance(10 * kMillisecond);
  }
}

TEST_CASE_METHOD(Fixture, "safe is neutral, and an unchanged pulse is not written again") {
  drive(esc, 1);
  esc.safe();
  bus.flush();
  CHECK(host::pwm1.writes.back().pulse == 1500000);
  const std::size_t writes = host::pwm1.writes.size();
  bus.flush();
  esc.safe();
  bus.flush();
  CHECK(host::pwm1.writes.size() == writes);
  esc.update();
  CHECK(esc.state.effort == 0);
  CHECK(esc.state.valid);
}

TEST_CASE_METHOD(Fixture, "once the robot has stopped, what is safe is written whether it seems to be or not") {
  drive(esc, 1);
  esc.safe();
  bus.flush();
  const std::size_t writes = host::pwm1.writes.size();
  detail::set_stopped(true);
  esc.safe();
  bus.flush();
  REQUIRE(host::pwm1.writes.size() == writes + 1);
  CHECK(host::pwm1.writes.back().pulse == 1500000);
}

TEST_CASE_METHOD(Fixture, "a channel the part does not have is ignored") {
  PwmEsc other{{}, {bus, 5}};
  drive(other, 1);
  CHECK(host::pwm1.writes.empty());
}
