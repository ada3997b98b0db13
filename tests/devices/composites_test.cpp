// Chassis, gimbal and arm: kinematics, loops that converge on simple plants, and no torque without fresh inputs.
#include <cmath>
#include <vector>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "finemote/devices/gimbal.hpp"
#include "finemote/devices/mecanum_chassis.hpp"
#include "finemote/devices/serial_arm.hpp"

namespace {

using namespace finemote;

constexpr double kStep = 0.001;  ///< s

/// A motor with inertia and friction that obeys only valid commands.
struct Plant {
  explicit Plant(double inertia = 0.02, double friction = 0.05) : inertia(inertia), friction(friction) {}
  void step() {
    const double torque = command.valid ? static_cast<double>(command.torque) : 0;
    speed += (torque - friction * speed) / inertia * kStep;
    angle += speed * kStep;
    if (silent) return;
    state.angle = static_cast<float>(angle);
    state.speed = static_cast<float>(speed);
    state.origin = now();
    state.valid = true;
  }
  double inertia, friction, speed = 0, angle = 0;
  bool silent = false;
  MotorState state;
  MotorCommand command;
};

template <class Root>
void pass(Root& root, std::vector<Plant*> plants, RemoteState& remote, int steps) {
  for (int i = 0; i < steps; ++i) {
    host::advance(1 * kMillisecond);
    for (Plant* plant : plants) plant->step();
    remote.origin = now();
    remote.valid = true;
    root.update();
    root.handle();
  }
}

struct ChassisFixture {
  ChassisFixture() {
    bench::reset();
    remote.left_switch = RemoteSwitch::kUp;
  }
  void pass(int steps) { ::pass(chassis, {&wheel[0], &wheel[1], &wheel[2], &wheel[3]}, remote, steps); }
  Plant wheel[4];
  RemoteState remote;
  Port<Motor> wheels[4] = {{wheel[0].state, wheel[0].command},
                           {wheel[1].state, wheel[1].command},
                           {wheel[2].state, wheel[2].command},
                           {wheel[3].state, wheel[3].command}};
  MecanumChassis chassis{{}, nullptr, wheels, {remote}};
};

}  // namespace

TEST_CASE_METHOD(ChassisFixture, "mecanum kinematics and their inverse") {
  float speeds[4];
  chassis.wheel_speeds({1, 0, 0}, speeds);
  for (const float s : speeds) CHECK(s == Approx(1 / 0.076));
  chassis.wheel_speeds({0, 1, 0}, speeds);  // to the left: front left and rear right backwards
  CHECK(speeds[0] < 0);
  CHECK(speeds[1] > 0);
  CHECK(speeds[2] > 0);
  CHECK(speeds[3] < 0);
  chassis.wheel_speeds({0, 0, 1}, speeds);  // turning left: left wheels backwards
  CHECK(speeds[0] == Approx(-0.4 / 0.076));
  CHECK(speeds[1] == Approx(0.4 / 0.076));
  chassis.wheel_speeds({0.3F, -0.7F, 1.9F}, speeds);
  const MecanumChassis::Motion motion = chassis.body_motion(speeds);
  CHECK(motion.forward == Approx(0.3));
  CHECK(motion.left == Approx(-0.7));
  CHECK(motion.turn == Approx(1.9));
}

TEST_CASE_METHOD(ChassisFixture, "wheels whose joints are known may come in any order and turn either way") {
  // Rear right, its axis to the right; then front left, rear left, front right. Corners at (+-0.3, +-0.2).
  constexpr RollingWheel known[] = {{-1, 1, -0.5F, -0.25F, 0.25F, -0.5F},
                                    {1, -1, -0.5F, 0.25F, -0.25F, -0.5F},
                                    {1, 1, -0.5F, 0.25F, 0.25F, -0.5F},
                                    {1, 1, 0.5F, 0.25F, 0.25F, 0.5F}};
  const MecanumChassis other{{}, known, wheels, {remote}};
  float speeds[4];
  other.wheel_speeds({0.3F, -0.7F, 1.9F}, speeds);
  CHECK(speeds[0] * 0.076 == Approx(-(0.3 + 0.7 + 0.95)));
  CHECK(speeds[3] * 0.076 == Approx(0.3 - 0.7 + 0.95));
  const MecanumChassis::Motion motion = other.body_motion(speeds);
  CHECK(motion.forward == Approx(0.3));
  CHECK(motion.left == Approx(-0.7));
  CHECK(motion.turn == Approx(1.9));
}

TEST_CASE_METHOD(ChassisFixture, "the chassis reaches the speed asked for") {
  remote.left_y = 0.5F;
  remote.right_x = -0.25F;
  pass(3000);
  CHECK(chassis.motion().forward == Approx(1).epsilon(0.02));
  CHECK(chassis.motion().left == Approx(0).margin(0.02));
  CHECK(chassis.motion().turn == Approx(1).epsilon(0.02));
  remote.left_y = remote.right_x = 0;
  pass(3000);
  CHECK(chassis.motion().forward == Approx(0).margin(0.02));
}

TEST_CASE_METHOD(ChassisFixture, "no torque with the switch down, without the remote, or without a wheel") {
  remote.left_y = 1;
  pass(200);
  CHECK(wheel[0].command.valid);
  remote.left_switch = RemoteSwitch::kDown;
  pass(1);
  for (const Plant& w : wheel) CHECK_FALSE(w.command.valid);
  remote.left_switch = RemoteSwitch::kMiddle;
  pass(1);
  CHECK(wheel[0].command.valid);
  wheel[3].silent = true;
  pass(150);
  for (const Plant& w : wheel) CHECK_FALSE(w.command.valid);
  CHECK(wheel[0].command.origin == wheel[3].state.origin);
  wheel[3].silent = false;
  pass(1);
  CHECK(wheel[0].command.valid);
  host::advance(101 * kMillisecond);
  for (Plant& w : wheel) w.step();
  chassis.update();
  chassis.handle();
  for (const Plant& w : wheel) CHECK_FALSE(w.command.valid);
}

TEST_CASE("the gimbal holds its aim, follows the sticks and respects the pitch limit") {
  bench::reset();
  Plant yaw, pitch;
  RemoteState remote;
  ImuState head;
  remote.right_switch = RemoteSwitch::kUp;
  Gimbal gimbal{{},     nullptr, nullptr, nullptr, nullptr, {yaw.state, yaw.command}, {pitch.state, pitch.command},
                {head}, {remote}};
  double base = 0.5;  // heading of what carries it
  const auto run = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      head.yaw = wrap_angle(static_cast<float>(base + yaw.angle));
      head.pitch = static_cast<float>(pitch.angle);
      head.rate[2] = static_cast<float>(yaw.speed);
      head.rate[1] = static_cast<float>(pitch.speed);
      head.origin = now();
      head.valid = true;
      pass(gimbal, {&yaw, &pitch}, remote, 1);
    }
  };
  run(10);
  CHECK(gimbal.yaw_aim() == Approx(0.5).margin(0.01));
  base = 0.9;  // the base turns away
  run(2000);
  CHECK(head.yaw == Approx(0.5).margin(0.01));
  remote.wheel = -0.5F;
  run(500);
  remote.wheel = 0;
  run(2000);
  CHECK(head.yaw == Approx(0.5 + 0.75).margin(0.02));
  remote.right_y = -1;  // look down, for long
  run(3000);
  remote.right_y = 0;
  run(1000);
  CHECK(pitch.angle > 0.48);
  CHECK(pitch.angle < 0.52);
  remote.right_switch = RemoteSwitch::kDown;
  run(1);
  CHECK_FALSE(yaw.command.valid);
  CHECK_FALSE(pitch.command.valid);
  remote.right_switch = RemoteSwitch::kUp;
  run(10);
  CHECK(yaw.command.valid);
  head.valid = false;
  pass(gimbal, {&yaw, &pitch}, remote, 1);
  CHECK_FALSE(yaw.command.valid);
}

TEST_CASE("the arm holds what it finds, jogs its joints, and lets go without fresh inputs") {
  bench::reset();
  std::vector<Plant> joints(6, Plant{0.2, 0.5});
  std::vector<Plant*> plants;
  std::vector<Port<Motor>> ports;
  for (Plant& joint : joints) {
    joint.angle = 0.3;
    plants.push_back(&joint);
    ports.push_back({joint.state, joint.command});
  }
  RemoteState remote;
  remote.right_switch = RemoteSwitch::kUp;
  SerialArm arm{{}, nullptr, nullptr, {ports.data(), ports.size()}, {remote}};
  pass(arm, plants, remote, 2000);
  for (const Plant& joint : joints) CHECK(joint.angle == Approx(0.3).margin(0.005));
  remote.right_x = 0.5F;
  remote.left_switch = RemoteSwitch::kDown;
  remote.wheel = -1;
  pass(arm, plants, remote, 1000);
  remote.right_x = remote.wheel = 0;
  pass(arm, plants, remote, 3000);
  CHECK(joints[0].angle == Approx(0.8).margin(0.02));
  CHECK(joints[1].angle == Approx(0.3).margin(0.005));
  CHECK(joints[4].angle == Approx(0.3).margin(0.005));
  CHECK(joints[5].angle == Approx(-0.7).margin(0.05));
  joints[2].silent = true;
  pass(arm, plants, remote, 150);
  for (const Plant& joint : joints) CHECK_FALSE(joint.command.valid);
}

TEST_CASE("the arm aims at no angle beyond the limits of a joint, and throws none back that stands outside") {
  bench::reset();
  constexpr JointRange ranges[] = {{-0.5F, 0.4F}, {-3e38F, 3e38F}};
  Plant joints[2] = {Plant{0.2, 0.5}, Plant{0.2, 0.5}};
  RemoteState remote;
  remote.right_switch = RemoteSwitch::kUp;
  remote.right_x = remote.right_y = 1;
  const Port<Motor> ports[] = {{joints[0].state, joints[0].command}, {joints[1].state, joints[1].command}};
  SerialArm arm{{}, nullptr, ranges, ports, {remote}};
  pass(arm, {&joints[0], &joints[1]}, remote, 3000);
  CHECK(arm.aim(0) == Approx(0.4).margin(0.05));
  CHECK(joints[1].angle > 2);
  remote.right_switch = RemoteSwitch::kDown;
  pass(arm, {&joints[0], &joints[1]}, remote, 1);
  joints[0].angle = 0.9;
  joints[0].speed = 0;
  remote.right_switch = RemoteSwitch::kUp;
  pass(arm, {&joints[0], &joints[1]}, remote, 500);
  CHECK(joints[0].angle == Approx(0.9).margin(0.01));
  remote.right_x = -1;
  pass(arm, {&joints[0], &joints[1]}, remote, 3000);
  CHECK(arm.aim(0) == Approx(-0.5).margin(0.05));
}

TEST_CASE("an aim never runs away from a joint that does not move") {
  bench::reset();
  Plant joint{1e6, 1};
  RemoteState remote;
  remote.right_switch = RemoteSwitch::kUp;
  remote.right_x = 1;
  const Port<Motor> ports[] = {{joint.state, joint.command}};
  SerialArm arm{{}, nullptr, nullptr, ports, {remote}};
  pass(arm, {&joint}, remote, 5000);
  CHECK(arm.aim(0) == Approx(0.3).margin(0.01));
  CHECK(joint.command.torque <= 5);
}

TEST_CASE("a gimbal whose motors turn the other way holds its aim as well") {
  bench::reset();
  Plant yaw, pitch;
  RemoteState remote;
  ImuState head;
  remote.right_switch = RemoteSwitch::kUp;
  constexpr Vector down{0, 0, -1}, right{0, -1, 0};
  Gimbal gimbal{{},     &down,   &right, nullptr, nullptr, {yaw.state, yaw.command}, {pitch.state, pitch.command},
                {head}, {remote}};
  double base = 0;
  const auto run = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      head.yaw = wrap_angle(static_cast<float>(base - yaw.angle));
      head.pitch = static_cast<float>(-pitch.angle);
      head.rate[2] = static_cast<float>(-yaw.speed);
      head.rate[1] = static_cast<float>(-pitch.speed);
      head.origin = now();
      head.valid = true;
      pass(gimbal, {&yaw, &pitch}, remote, 1);
    }
  };
  run(10);
  base = 0.4;
  remote.right_y = -1;  // look down, for long
  run(3000);
  CHECK(head.yaw == Approx(0).margin(0.01));
  CHECK(head.pitch == Approx(0.5).margin(0.02));
}

TEST_CASE("a gimbal aims at no yaw and no pitch that its joints do not reach") {
  bench::reset();
  for (const bool reversed : {false, true}) {
    Plant yaw, pitch;
    RemoteState remote;
    ImuState head;
    remote.right_switch = RemoteSwitch::kUp;
    constexpr Vector down{0, 0, -1};
    constexpr JointRange yaw_range{-0.3F, 0.8F}, pitch_range{-0.4F, 0.2F};  // about z and y, whichever way motors turn
    Gimbal gimbal{{},
                  reversed ? &down : nullptr,
                  nullptr,
                  &yaw_range,
                  &pitch_range,
                  {yaw.state, yaw.command},
                  {pitch.state, pitch.command},
                  {head},
                  {remote}};
    const double way = reversed ? -1 : 1;
    double base = 3;
    const auto run = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        head.yaw = wrap_angle(static_cast<float>(base + way * yaw.angle));
        head.pitch = static_cast<float>(pitch.angle);
        head.rate[2] = static_cast<float>(way * yaw.speed);
        head.rate[1] = static_cast<float>(pitch.speed);
        head.origin = now();
        head.valid = true;
        pass(gimbal, {&yaw, &pitch}, remote, 1);
      }
    };
    remote.wheel = -1;    // left, for long
    remote.right_y = -1;  // and down
    run(3000);
    CHECK(way * yaw.angle == Approx(0.8).margin(0.02));
    CHECK(pitch.angle == Approx(0.2).margin(0.02));
    remote.wheel = 1;
    run(3000);
    CHECK(way * yaw.angle == Approx(-0.3).margin(0.02));
    remote.wheel = 0;
    base = 3.5;  // the base turns away: the aim goes with it as far as the joint does not reach
    run(2000);
    CHECK(way * yaw.angle == Approx(-0.3).margin(0.02));
  }
}

TEST_CASE("an arm carries its weight in every pose") {
  bench::reset();
  // A turning base, an upper arm of 0.4 m with 2 kg at its middle, a forearm with 1 kg 0.3 m ahead.
  constexpr ChainLink chain[] = {{{0, 0, 0.1F}, {0, 0, 1}, {0, 0, 0.1F}, 3},
                                 {{0, 0, 0.2F}, {0, 1, 0}, {0, 0, 0.2F}, 2},
                                 {{0, 0, 0.4F}, {0, -1, 0}, {0, 0, 0.3F}, 1}};
  Plant joints[3];
  RemoteState remote;
  remote.right_switch = RemoteSwitch::kUp;
  const Port<Motor> ports[] = {
      {joints[0].state, joints[0].command}, {joints[1].state, joints[1].command}, {joints[2].state, joints[2].command}};
  SerialArm arm{{}, chain, nullptr, ports, {remote}};
  const auto weigh = [&](double base, double shoulder, double elbow) {
    joints[0].angle = base;
    joints[1].angle = shoulder;
    joints[2].angle = elbow;
    for (Plant& joint : joints) joint.speed = 0;
    pass(arm, {&joints[0], &joints[1], &joints[2]}, remote, 1);
  };
  weigh(0, 0, 0);  // straight up
  for (unsigned n = 0; n < 3; ++n) CHECK(arm.weight(n) == Approx(0).margin(0.01));
  weigh(1.1, M_PI / 2, 0);  // stretched out forward, wherever the base points
  CHECK(arm.weight(0) == Approx(0).margin(0.01));
  CHECK(arm.weight(1) == Approx(-9.80665 * (2 * 0.2 + 1 * 0.7)).epsilon(1e-3));
  CHECK(arm.weight(2) == Approx(9.80665 * 0.3).epsilon(1e-3));
  weigh(-0.4 + 8 * M_PI, M_PI / 2, M_PI / 2);  // the forearm up again
  CHECK(arm.weight(1) == Approx(-9.80665 * (2 * 0.2 + 1 * 0.4)).epsilon(1e-3));
  CHECK(arm.weight(2) == Approx(0).margin(0.01));
  weigh(0, 0.5, 0.2);
  const double across = 0.4 * std::sin(0.5) + 0.3 * std::sin(0.3);
  CHECK(arm.weight(1) == Approx(-9.80665 * (2 * 0.2 * std::sin(0.5) + across)).epsilon(1e-3));
  CHECK(joints[1].command.torque == Approx(arm.weight(1)).margin(0.6));
  weigh(0, M_PI / 2, 0);  // more than it may give
  CHECK(joints[1].command.torque == Approx(-5));
  joints[0].silent = true;
  pass(arm, {&joints[0], &joints[1], &joints[2]}, remote, 150);
  for (const Plant& joint : joints) CHECK(joint.command.torque == 0);
}

TEST_CASE("rotations follow the right hand, and one after the other") {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const auto is = [](const Vector& a, const Vector& b) {
    CHECK(a.x == Approx(b.x).margin(1e-6));
    CHECK(a.y == Approx(b.y).margin(1e-6));
    CHECK(a.z == Approx(b.z).margin(1e-6));
  };
  const float quarter = 1.57079633F;
  is(Rotation::about(z, quarter) * x, y);
  is(Rotation::about(x, quarter) * y, z);
  is(Rotation::about(y, quarter) * z, x);
  is(Rotation::about(z, quarter) * Rotation::about(x, quarter) * y, z);
  is(Rotation::about(x, quarter) * Rotation::about(z, quarter) * y, -1.0F * x);
  is(Rotation::about({0.6F, 0, 0.8F}, 3.14159265F) * Vector{0.6F, 0, 0.8F}, {0.6F, 0, 0.8F});
}
