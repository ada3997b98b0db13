// Servo: pulses, limits, and what it does without data.
#include "finemote/devices/pwm_servo.hpp"

#include <cmath>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using OnLoss = PwmServo::OnLoss;

struct Fixture {
  Fixture() {
    bench::reset();
    bus.start();
    host::advance(10 * kSecond);
  }
  std::uint32_t drive(PwmServo& servo, float angle, Duration age = 0) {
    servo.command.angle = angle;
    servo.command.origin = now() - age;
    servo.command.valid = true;
    servo.handle();
    servo.update();
    bus.flush();
    return host::pwm1.writes.empty() ? 0 : host::pwm1.writes.back().pulse;
  }
  static PwmServo::Config config(OnLoss on_loss, bool reverse = false) {
    return {500000, 2500000, 3.14159265F, reverse, 500000000, on_loss};
  }
  PwmBus bus{ports::pwm1};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "angles become pulses, and are cut at the ends of the travel") {
  PwmServo servo{config(OnLoss::kHold), {bus, 0}};
  CHECK(drive(servo, 0) == 1500000);
  CHECK(drive(servo, 0.785398F) == Approx(2000000).margin(2));
  CHECK(drive(servo, -10) == 500000);
  CHECK(servo.state.angle == Approx(-1.5708).epsilon(1e-4));
  PwmServo reversed{config(OnLoss::kHold, true), {bus, 0}};
  CHECK(drive(reversed, 0.785398F) == Approx(1000000).margin(2));
}

TEST_CASE_METHOD(Fixture, "without fresh data it stays, goes to the middle, or falls limp") {
  const auto [on_loss, expected] = GENERATE(
      table<OnLoss, std::uint32_t>({{OnLoss::kHold, 2500000U}, {OnLoss::kCentre, 1500000U}, {OnLoss::kRelease, 0U}}));
  PwmServo servo{config(on_loss), {bus, 0}};
  CHECK(drive(servo, 3) == 2500000);
  CHECK(drive(servo, 0, 500 * kMillisecond + 1) == expected);
  CHECK(drive(servo, 3) == 2500000);
  CHECK(drive(servo, NAN) == expected);
}

TEST_CASE_METHOD(Fixture, "angles beyond the limits of the joint are cut, on loss of data too") {
  const JointRange range{0.25F, 1.0F};
  PwmServo servo{config(OnLoss::kCentre), &range, {bus, 0}};
  CHECK(drive(servo, 3) == servo.pulse(1.0F));
  CHECK(servo.state.angle == 1.0F);
  CHECK(drive(servo, -3) == servo.pulse(0.25F));
  CHECK(drive(servo, 1, 500 * kMillisecond + 1) == servo.pulse(0.25F));
  const JointRange wide{-9, 9};
  PwmServo free{config(OnLoss::kCentre), &wide, {bus, 0}};
  CHECK(drive(free, 9) == 2500000);
}
