// Plants that couple motors with what they move, against mechanics worked out by hand.
#include <array>
#include <numbers>

#include "catch.hpp"
#include "emulator/plants/mecanum_base.hpp"
#include "emulator/plants/standing_body.hpp"
#include "emulator/plants/weights.hpp"

using namespace finemote::emulator;

TEST_CASE("a base on mecanum wheels goes where rolling takes it, and pulls at its wheels") {
  MecanumBase::Parameters figures;
  figures.mass = 10;
  figures.inertia = 0.4;
  MecanumBase base(figures);
  MotorShaft::Parameters heavy;  // turns as it is told, whatever pulls
  heavy.inertia = 1e6;
  heavy.viscous = 0;
  std::vector<MotorShaft> wheels(4, MotorShaft(heavy));
  const double x[] = {0.2, 0.2, -0.2, -0.2}, y[] = {0.3, -0.3, 0.3, -0.3};
  const auto turn = [&](std::array<double, 4> speeds) {
    for (unsigned n = 0; n < 4; ++n) wheels[n].drive(0, 1e6 * speeds[n]);
    for (MotorShaft& wheel : wheels) wheel.speed(from_ns(1'000'000'000));
    for (MotorShaft& wheel : wheels) wheel.drive(from_ns(1'000'000'000), 0);
    for (unsigned n = 0; n < 4; ++n) {
      const double side = x[n] * y[n] > 0 ? -1 : 1;
      base.add_wheel({&wheels[n], 0.1, {x[n], y[n]}, {1, 0}, Eigen::Vector2d(1, side).normalized()});
    }
    const Time begin = from_ns(1'000'000'000);
    for (unsigned i = 0; i <= 4 * 2000; ++i) base.step(begin + i * MecanumBase::kStep);
    return base.motion(begin + 8000 * MecanumBase::kStep);
  };
  SECTION("forward") {
    const Motion m = turn({5, 5, 5, 5});
    CHECK(m.position.x() > 0.4);  // 0.5 m/s for 2 s, less what it takes to begin
    CHECK(m.position.x() < 1.0);
    CHECK(std::abs(m.position.y()) < 1e-9);
    CHECK(m.force.x() == Approx(0).margin(0.01));
  }
  SECTION("to the left") {
    const Motion m = turn({-5, 5, 5, -5});
    CHECK(m.position.y() > 0.4);
    CHECK(std::abs(m.position.x()) < 1e-9);
  }
  SECTION("about itself: 0.5 m/s at an arm of 0.2 + 0.3 m") {
    const Motion m = turn({-5, 5, -5, 5});
    CHECK(m.rate.z() == Approx(1).epsilon(0.02));
  }
  SECTION("friction is its limit: no faster than 0.7 g / sqrt 2") {
    const Motion m = turn({500, 500, 500, 500});
    CHECK(m.force.x() == Approx(0.7 * 9.80665 / std::sqrt(2) * std::exp(-0.4 * 2)).epsilon(1e-3));
  }
}

TEST_CASE("a wheel that carries a base feels its mass") {
  MecanumBase::Parameters figures;
  figures.mass = 10;
  figures.drag = 0;
  MecanumBase base(figures);
  MotorShaft::Parameters light;
  light.inertia = 0.004;
  light.viscous = 0;
  std::vector<MotorShaft> wheels(4, MotorShaft(light));
  for (unsigned n = 0; n < 4; ++n) {
    wheels[n].drive(0, 0.5);
    base.add_wheel({&wheels[n],
                    0.1,
                    {n < 2 ? 0.2 : -0.2, n % 2 == 0 ? 0.2 : -0.2},
                    {1, 0},
                    Eigen::Vector2d(1, n == 0 || n == 3 ? -1 : 1).normalized()});
  }
  for (unsigned i = 0; i < 4000; ++i) base.step(i * MecanumBase::kStep);
  // 4 * 0.5 N m at 0.1 m push 10 kg and four wheels of 0.004 / 0.1^2 = 0.4 kg: 20 N / 11.6 kg.
  const double speed = wheels[0].speed(4000 * MecanumBase::kStep) * 0.1;
  CHECK(speed == Approx(20 / 11.6).epsilon(0.03));
}

TEST_CASE("what hangs at a joint pulls at it, over the joints between") {
  StandingBody body;
  MotorShaft::Parameters still;
  still.inertia = 1e9;
  still.viscous = 0;
  MotorShaft shoulder(still), elbow(still);
  Weights weights(body);
  Weights::Node upper, fore;
  upper.shaft = &shoulder;
  upper.axis = Eigen::Vector3d::UnitY();
  upper.mass = 2;
  upper.centre = {0.2, 0, 0};
  fore.shaft = &elbow;
  fore.before = weights.add(upper);
  JointStep out;
  out.xyz = {0.4, 0, 0};
  fore.way.push_back(out);
  fore.axis = Eigen::Vector3d::UnitY();
  fore.mass = 1;
  fore.centre = {0.3, 0, 0};
  weights.add(fore);
  // What pulls shows in what it does to the shaft within a second: 1e9 kg m^2 give 1e-9 rad/s per N m.
  weights.step(0);
  const Time second = from_ns(1'000'000'000);
  CHECK(shoulder.speed(second) * 1e9 == Approx(9.80665 * (2 * 0.2 + 0.7)).epsilon(1e-6));
  CHECK(elbow.speed(second) * 1e9 == Approx(9.80665 * 0.3).epsilon(1e-6));
  body.place(second, Angles{0, std::numbers::pi / 2, 0});  // the arm hangs down
  const double before = elbow.speed(second);
  weights.step(second);
  CHECK((elbow.speed(2 * second) - before) * 1e9 == Approx(0).margin(1e-6));
}
