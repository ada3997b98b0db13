// The models of RoboMaster parts and the plants behind them, against figures from data sheets and from mechanics.
#include <algorithm>
#include <map>
#include <numbers>

#include "catch.hpp"
#include "emulator/outfit/outfit.hpp"
#include "emulator/parts/bmi088.hpp"
#include "emulator/parts/dji_motor.hpp"
#include "emulator/parts/ist8310.hpp"
#include "emulator/parts/remote.hpp"
#include "emulator/plants/heated_mass.hpp"
#include "emulator/plants/mount.hpp"
#include "emulator/plants/standing_body.hpp"
#include "emulator/plants/submerged_body.hpp"
#include "tests/emulator/motor_line.hpp"

using namespace finemote::emulator;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr Time kMs = from_ns(1'000'000);

std::uint32_t bits(const std::vector<std::uint8_t>& bytes, unsigned at, unsigned count) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < count; ++i) value |= (bytes[(at + i) / 8] >> (at + i) % 8 & 1U) << i;
  return value;
}

}  // namespace

TEST_CASE("a DBUS frame carries sticks, switches, keys and wheel where the manual says") {
  Hands hands;
  hands.right_x = 1;
  hands.left_y = -1;
  hands.left_switch = Hands::kUp;
  hands.right_switch = Hands::kDown;
  hands.wheel = 0.5;
  hands.keys = 0x8001;
  const auto frame = dbus_frame(hands);
  REQUIRE(frame.size() == 18);
  CHECK(bits(frame, 0, 11) == 1684);
  CHECK(bits(frame, 11, 11) == 1024);
  CHECK(bits(frame, 22, 11) == 1024);
  CHECK(bits(frame, 33, 11) == 364);
  CHECK(frame[5] >> 6 == 1);
  CHECK((frame[5] >> 4 & 3) == 2);
  CHECK((frame[14] | frame[15] << 8) == 0x8001);
  CHECK(bits(frame, 128, 11) == 1354);
}

TEST_CASE("an SBUS frame has its ends, sixteen channels and the failsafe flag") {
  Hands hands;
  hands.right_x = -1;
  hands.left_switch = Hands::kDown;
  auto frame = sbus_frame(hands);
  REQUIRE(frame.size() == 25);
  CHECK(frame[0] == 0x0F);
  CHECK(frame[24] == 0x00);
  CHECK(bits(frame, 8, 11) == 173);
  CHECK(bits(frame, 8 + 4 * 11, 11) == 1812);
  CHECK(bits(frame, 8 + 15 * 11, 11) == 992);
  CHECK(frame[23] == 0);
  hands.failsafe = true;
  frame = sbus_frame(hands);
  CHECK((frame[23] & 0x08) != 0);
}

TEST_CASE("a shaft turns as its torque, inertia and friction say, and stops at its end") {
  MotorShaft::Parameters p;
  p.inertia = 0.02;
  p.viscous = 0.1;
  p.coulomb = 0.2;
  MotorShaft shaft(p);
  shaft.drive(0, 0.19);  // less than the friction holds
  CHECK(shaft.speed(100 * kMs) == 0);
  shaft.drive(100 * kMs, 1.2);  // (1.2 - 0.2) / 0.1 = 10 rad/s, with a time constant of 0.02 / 0.1 = 0.2 s
  CHECK(shaft.speed(300 * kMs) == Approx(10 * (1 - std::exp(-1.0))).epsilon(1e-3));
  CHECK(shaft.speed(3000 * kMs) == Approx(10).epsilon(1e-3));
  p.upper = 1.0;
  MotorShaft stopped(p);
  stopped.drive(0, 2);
  CHECK(stopped.angle(1000 * kMs) == 1.0);
  CHECK(stopped.speed(1000 * kMs) == 0);
}

TEST_CASE("the supply's voltage limits a shaft's speed, in the direction it drives") {
  MotorShaft::Parameters p;
  p.inertia = 0.01;
  p.viscous = 0;
  p.free_speed = 50;
  MotorShaft shaft(p);
  shaft.drive(0, 5);
  CHECK(shaft.speed(2000 * kMs) == Approx(50).epsilon(1e-3));
  CHECK(shaft.torque(2000 * kMs) == Approx(0).margin(0.01));
  shaft.drive(2000 * kMs, -5);
  CHECK(shaft.torque(2000 * kMs) == -5);  // braking is not limited
}

TEST_CASE("a DJI motor takes its word of the group and reports angle, speed and current of the rotor") {
  finemote::test::MotorLine motors;
  auto& [world, line, heard, command] = motors;
  DjiMotor::Figures f;
  f.feedback_id = 0x203;
  f.word = 2;
  f.gear = 19.2;
  f.torque_per_ampere = 0.3;
  MotorShaft::Parameters p;
  p.inertia = 0.01;
  p.viscous = 0.3;
  DjiMotor motor(world, line, f, p);
  // Without a processor the world's clock stands: everything happens at once, in order.
  world.queue().run(from_ns(1));
  command = CanFrame{0x200, 8, {0, 0, 0, 0, 0x20, 0x00, 0, 0}};  // 8192 of 16384: 10 A
  line.request();
  world.queue().run(300 * from_ns(1000));
  CHECK(motor.command() == 8192);
  CHECK(motor.current() == Approx(10));
  CHECK(motor.commands() == 1);
  command = CanFrame{0x1FF, 8, {0, 0, 0, 0, 0x7F, 0, 0, 0}};
  line.request();
  world.queue().run(600 * from_ns(1000));
  CHECK(motor.commands() == 1);
  REQUIRE(heard.size() == 3);  // two commands and its report
  CHECK(std::count_if(heard.begin(), heard.end(), [](const CanFrame& it) { return it.id == 0x203 && it.size == 8; }) ==
        1);
  CHECK(motor.shaft().speed(10'000 * kMs) == Approx(10).epsilon(1e-3));  // 3 N m against 0.3 N m s
}

TEST_CASE("the inertial sensor wakes up as its data sheet asks, and gives acceleration and rates in its ranges") {
  Time now = 0;
  Motion motion;
  motion.rate = {1.0, -2.0, 0.5};
  Bmi088 part(
      {[&] { return now; }, [](Time, EventQueue::Action) {}}, [&](Time) { return motion; }, [](Time) { return 25; });
  SpiPart accelerometer = part.accelerometer(), gyroscope = part.gyroscope();
  const auto exchange = [](SpiPart& chip, const std::vector<int>& bytes) {
    std::vector<int> answer;
    chip.select(true);
    for (const int byte : bytes) answer.push_back(chip.exchange(static_cast<std::uint8_t>(byte)));
    chip.select(false);
    return answer;
  };
  const auto word = [](const std::vector<int>& bytes, unsigned at) {
    return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
  };
  now = 40 * kMs;
  CHECK(exchange(accelerometer, {0x80, 0, 0})[2] == 0xFF);  // still on I2C
  CHECK(exchange(accelerometer, {0x80, 0, 0})[2] == 0x1E);  // the first select has turned it
  CHECK(exchange(gyroscope, {0x80, 0})[1] == 0x0F);
  CHECK(word(exchange(accelerometer, {0x92, 0, 0, 0, 0, 0, 0, 0}), 6) == 0);  // suspended
  exchange(accelerometer, {0x7D, 0x04});
  exchange(accelerometer, {0x7C, 0x00});
  exchange(accelerometer, {0x41, 0x01});
  exchange(gyroscope, {0x10, 0x82});
  Time sampled = 0;
  part.on_sample = [&](Bmi088::Quantity, Time from) {
    sampled = from;
    return Tag::none;
  };
  now = 41 * kMs + 1234 * from_ns(100);
  CHECK(word(exchange(accelerometer, {0x92, 0, 0, 0, 0, 0, 0, 0}), 6) == Approx(32768 / 6).margin(1));  // 1 g of 6
  const auto rates = exchange(gyroscope, {0x82, 0, 0, 0, 0, 0, 0});
  CHECK(word(rates, 1) == Approx(1 / kDegree * 16.384).margin(1));
  CHECK(word(rates, 3) == Approx(-2 / kDegree * 16.384).margin(1));
  CHECK(sampled <= now);
  CHECK(now - sampled <= from_ns(10'000'000));  // as ACC_CONF was left: 100 Hz
  exchange(gyroscope, {0x14, 0xB6});
  CHECK(exchange(gyroscope, {0x80, 0})[1] == 0xFF);  // starting again
  part.silent = true;
  CHECK(exchange(accelerometer, {0x80, 0, 0})[2] == 0xFF);
}

namespace {

/// An inertial sensor whose outputs are watched, set up through its registers, with a clock that jumps from event to
/// event.
struct WatchedSensor {
  struct Change {
    Time at;
    int level;
  };
  WatchedSensor() {
    part.on_output = [this](Bmi088::Output which, int level) { changes[which].push_back({now, level}); };
    run(40 * kMs);
    write(accelerometer, 0, 0);  // the first select turns it to SPI
    write(accelerometer, 0x7D, 0x04);
    write(accelerometer, 0x7C, 0x00);
    write(accelerometer, 0x40, 0xAB);  // 800 Hz
    write(gyroscope, 0x10, 0x82);      // 1000 Hz
  }
  void run(Time until) {
    while (queue.next() <= until) {
      now = queue.next();
      queue.run(now);
    }
    now = until;
  }
  static void write(SpiPart& chip, int address, int value) {
    chip.select(true);
    chip.exchange(static_cast<std::uint8_t>(address));
    chip.exchange(static_cast<std::uint8_t>(value));
    chip.select(false);
  }
  std::uint8_t read_accelerometer(int address) {
    accelerometer.select(true);
    accelerometer.exchange(static_cast<std::uint8_t>(address | 0x80));
    accelerometer.exchange(0);
    const std::uint8_t byte = accelerometer.exchange(0);
    accelerometer.select(false);
    return byte;
  }
  std::uint8_t read_gyroscope(int address) {
    gyroscope.select(true);
    gyroscope.exchange(static_cast<std::uint8_t>(address | 0x80));
    const std::uint8_t byte = gyroscope.exchange(0);
    gyroscope.select(false);
    return byte;
  }
  /// Gyroscope: data ready on INT3, with these levels.
  void announce(int conf) {
    write(gyroscope, 0x16, conf);
    write(gyroscope, 0x18, 0x01);
    write(gyroscope, 0x15, 0x80);
  }
  std::vector<Change>& of(Bmi088::Output which) { return changes[which]; }

  Time now = 0;
  EventQueue queue;
  double celsius = 25;
  Bmi088 part{{[this] { return now; }, [this](Time at, EventQueue::Action action) { queue.at(at, std::move(action)); }},
              [](Time) { return Motion{}; },
              [this](Time) { return celsius; }};
  SpiPart accelerometer = part.accelerometer(), gyroscope = part.gyroscope();
  std::map<Bmi088::Output, std::vector<Change>> changes;
};

using Output = Bmi088::Output;

}  // namespace

TEST_CASE("the gyroscope's output says every sample for 280 us, at the level and with the drive it is set to") {
  const auto [conf, idle, active] =
      GENERATE(table<int, int, int>({{0x00, 1, 0}, {0x01, 0, 1}, {0x02, -1, 0}, {0x03, 0, -1}}));
  INFO("INT3_INT4_IO_CONF " << conf);
  WatchedSensor sensor;
  sensor.run(50 * kMs + 1);
  CHECK(sensor.of(Output::int3).empty());
  sensor.announce(conf);
  if (idle != -1) {
    REQUIRE(sensor.of(Output::int3).size() == 1);  // it is driven, and waits
    CHECK(sensor.of(Output::int3)[0].level == idle);
  }
  sensor.of(Output::int3).clear();
  sensor.run(60 * kMs);
  const auto& seen = sensor.of(Output::int3);
  REQUIRE(seen.size() == 19);  // 51, 52, ... 59 ms, on and off; 60 ms on
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CHECK(seen[i].level == (i % 2 == 0 ? active : idle));
    CHECK(seen[i].at == (51 + i / 2) * kMs + (i % 2) * from_ns(280'000));
  }
  CHECK(sensor.of(Output::int4).empty());
  CHECK(sensor.of(Output::int1).empty());
  CHECK(sensor.read_gyroscope(0x0A) == 0x80);
  sensor.run(60 * kMs + from_ns(281'000));
  CHECK(sensor.read_gyroscope(0x0A) == 0);
}

TEST_CASE("data ready can go to the other output, and comes as often as the part samples") {
  WatchedSensor sensor;
  WatchedSensor::write(sensor.gyroscope, 0x10, 0x80);  // 2000 Hz
  WatchedSensor::write(sensor.gyroscope, 0x16, 0x04);  // INT4 push-pull, active high
  WatchedSensor::write(sensor.gyroscope, 0x18, 0x80);
  WatchedSensor::write(sensor.gyroscope, 0x15, 0x80);
  sensor.of(Output::int4).clear();
  sensor.run(50 * kMs + from_ns(400'000));
  CHECK(sensor.of(Output::int4).size() == 2 * 20);
  CHECK(sensor.of(Output::int3).empty());
  WatchedSensor::write(sensor.gyroscope, 0x11, 0x80);  // suspended
  sensor.of(Output::int4).clear();
  sensor.run(60 * kMs);
  CHECK(sensor.of(Output::int4).empty());
}

TEST_CASE("self-tests move the accelerometer as far as they must, and the gyroscope says that it passed") {
  WatchedSensor sensor;
  const auto acceleration = [&](unsigned axis) {
    const int low = sensor.read_accelerometer(0x12 + 2 * axis), high = sensor.read_accelerometer(0x13 + 2 * axis);
    return static_cast<std::int16_t>(low | high << 8);
  };
  static_cast<void>(sensor.read_accelerometer(0));  // turns to SPI
  WatchedSensor::write(sensor.accelerometer, 0x7C, 0x00);
  WatchedSensor::write(sensor.accelerometer, 0x7D, 0x04);
  WatchedSensor::write(sensor.accelerometer, 0x41, 0x03);  // 24 g
  constexpr int kLimits[] = {1365, 1365, 683};             // 1 g, 1 g, 0.5 g
  for (unsigned axis = 0; axis < 3; ++axis) {
    WatchedSensor::write(sensor.accelerometer, 0x6D, 0x0D);
    const int pushed = acceleration(axis);
    WatchedSensor::write(sensor.accelerometer, 0x6D, 0x09);
    CHECK(pushed - acceleration(axis) > kLimits[axis]);
  }
  WatchedSensor::write(sensor.gyroscope, 0x3C, 0x01);
  CHECK((sensor.read_gyroscope(0x3C) & 0x02) == 0);
  sensor.run(70 * kMs);
  CHECK((sensor.read_gyroscope(0x3C) & 0x06) == 0x02);  // done, not failed
}

TEST_CASE("a silent part says nothing, and one that lost its supply has forgotten where to say it") {
  WatchedSensor sensor;
  sensor.announce(0x00);
  sensor.run(50 * kMs + from_ns(100'000));
  sensor.part.silent = true;  // in the middle of a pulse, which ends
  sensor.of(Output::int3).clear();
  sensor.run(70 * kMs);
  REQUIRE(sensor.of(Output::int3).size() == 1);
  CHECK(sensor.of(Output::int3)[0].level == 1);
  sensor.part.silent = false;
  sensor.run(71 * kMs);
  CHECK(sensor.of(Output::int3).back().level == 0);
  sensor.part.power_cycle();
  CHECK(sensor.of(Output::int3).back().level == -1);
  sensor.of(Output::int3).clear();
  sensor.run(200 * kMs);
  CHECK(sensor.of(Output::int3).empty());
}

TEST_CASE("the accelerometer's output says its samples until their status is read") {
  WatchedSensor sensor;
  WatchedSensor::write(sensor.accelerometer, 0x58, 0x04);
  sensor.run(45 * kMs);
  CHECK(sensor.of(Output::int1).empty());  // not an output yet
  WatchedSensor::write(sensor.accelerometer, 0x53, 0x08);
  REQUIRE(sensor.of(Output::int1).size() == 1);
  CHECK(sensor.of(Output::int1)[0].level == 1);
  sensor.run(46 * kMs + from_ns(250'000) + from_ns(100'000));  // 37 * 1.25 ms
  REQUIRE(sensor.of(Output::int1).size() == 2);
  CHECK(sensor.of(Output::int1)[1].at == 37 * from_ns(1'250'000));
  CHECK(sensor.of(Output::int1)[1].level == 0);
  CHECK(sensor.read_accelerometer(0x1D) == 0x80);
  CHECK(sensor.of(Output::int1).back().level == 1);
  CHECK(sensor.of(Output::int1).size() == 3);
  CHECK(sensor.read_accelerometer(0x1D) == 0);
  sensor.run(48 * kMs);
  CHECK(sensor.of(Output::int1).size() == 5);  // without a read it ends by itself
  CHECK(sensor.read_accelerometer(0x1D) == 0x80);
  WatchedSensor::write(sensor.accelerometer, 0x7E, 0xB6);
  CHECK(sensor.of(Output::int1).back().level == -1);
}

TEST_CASE("the temperature register is not valid before the part is on, and then new every 1.28 s") {
  WatchedSensor sensor;
  const auto celsius = [&] {
    const auto word = static_cast<std::int16_t>(sensor.read_accelerometer(0x22) << 8 | sensor.read_accelerometer(0x23));
    return (word >> 5) * 0.125 + 23;
  };
  CHECK(celsius() == 25);
  sensor.celsius = -12.5;
  sensor.run(1300 * kMs);
  CHECK(celsius() == 25);
  sensor.run(1321 * kMs);
  CHECK(celsius() == -12.5);
  sensor.part.power_cycle();
  sensor.run(1400 * kMs);
  WatchedSensor::write(sensor.accelerometer, 0, 0);
  CHECK(celsius() == -105);  // 0x8000
}

TEST_CASE("a heated mass warms along its exponential, and whatever it is asked between does not matter") {
  HeatedMass mass({20, 80, 30}), looked_at({20, 80, 30});
  CHECK(mass.temperature(0) == 20);
  mass.heat(1000 * kMs, 0.5);
  looked_at.heat(1000 * kMs, 0.5);
  for (int i = 1; i < 600; ++i) CHECK(looked_at.temperature((1000 + i * 50) * kMs) < 60);
  CHECK(mass.temperature(31'000 * kMs) == Approx(60 - 40 * std::exp(-1.0)));
  CHECK(looked_at.temperature(31'000 * kMs) == Approx(mass.temperature(31'000 * kMs)).epsilon(1e-12));
  mass.set(31'000 * kMs, 100);
  mass.heat(31'000 * kMs, 0);
  CHECK(mass.temperature(61'000 * kMs) == Approx(20 + 80 * std::exp(-1.0)));
  CHECK(mass.temperature(600'000 * kMs) == Approx(20).margin(1e-5));
}

TEST_CASE("the compass answers at its address with its identity, and turns the field into its own axes") {
  Time now = from_ns(20'000'000);
  EventQueue queue;
  Ist8310 part(0x0E,
               {[&] { return now; }, [&](Time at, EventQueue::Action action) { queue.at(at, std::move(action)); }},
               [](Time) { return Eigen::Vector3d(30e-6, -15e-6, 0); });
  std::vector<int> levels;
  part.on_ready = [&](int level) { levels.push_back(level); };
  I2cLine line;
  line.attach(part);
  const auto write = [&](std::initializer_list<int> bytes) {
    REQUIRE(line.select(0x0E, false));
    for (const int byte : bytes) REQUIRE(line.write(static_cast<std::uint8_t>(byte)));
    line.stop();
  };
  const auto read = [&](unsigned count) {
    std::vector<int> bytes;
    REQUIRE(line.select(0x0E, true));
    for (unsigned i = 0; i < count; ++i) bytes.push_back(line.read());
    line.stop();
    return bytes;
  };
  write({0x00});
  CHECK(read(1)[0] == 0x10);
  write({0x03});
  CHECK(read(6) == std::vector<int>{0, 0, 0, 0, 0, 0});  // not measuring yet
  write({0x0B, 0x08});                                   // data ready on its pin, active low
  write({0x0A, 0x0B});
  const auto run_to = [&](std::uint64_t ns) {
    now = from_ns(ns);
    queue.run(now);
  };
  run_to(24'999'999);
  write({0x02});
  CHECK(read(1)[0] == 0);
  run_to(25'000'000);
  write({0x02});
  CHECK(read(1)[0] == 1);
  CHECK(levels == std::vector<int>{1, 0});
  run_to(30'000'000);
  write({0x02});
  CHECK(read(1)[0] == 3);  // another one, and nobody fetched the first
  write({0x03});
  CHECK(read(6) == std::vector<int>{100, 0, 50, 0, 0, 0});  // its y axis points to the right
  CHECK(levels == std::vector<int>{1, 0, 1});
  write({0x02});
  CHECK(read(1)[0] == 0);
  part.hold_reset(true);
  CHECK(!line.select(0x0E, false));
}

TEST_CASE("a sensor on two driven joints sees the sum of their angles and rates") {
  struct Fixed : Shaft {
    Fixed(double angle, double speed) : angle_(angle), speed_(speed) {}
    double angle(Time) override { return angle_; }
    double speed(Time) override { return speed_; }
    double angle_, speed_;
  } yaw(90 * kDegree, 2), pitch(-30 * kDegree, 0);
  StandingBody base;
  Mount head(base,
             {{{0, 0, 0.1}, {}, Eigen::Vector3d::UnitZ(), &yaw}, {{0.2, 0, 0}, {}, Eigen::Vector3d::UnitY(), &pitch}});
  const Motion motion = head.motion(0);
  const Angles angles = angles_of(motion.attitude);
  CHECK(angles.yaw / kDegree == Approx(90));
  CHECK(angles.pitch / kDegree == Approx(-30));
  CHECK(motion.position.y() == Approx(0.2));
  CHECK(motion.position.z() == Approx(0.1));
  CHECK(motion.rate.z() == Approx(2 * std::cos(30 * kDegree)));  // about the world's vertical, in the tilted frame
  CHECK(motion.rate.x() == Approx(2 * std::sin(30 * kDegree)));
  CHECK(motion.force.x() == Approx(kGravity * std::sin(30 * kDegree)));
}

TEST_CASE("a hull floats, sinks under thrust, rights itself, and takes the moments of its thrusters") {
  SubmergedBody::Parameters p;
  p.mass = 5;
  p.inertia = Eigen::Vector3d(0.06, 0.07, 0.09).asDiagonal();
  SubmergedBody hull(p);
  CHECK(hull.depth(5000 * kMs) == Approx(0).margin(1e-6));
  const auto down = hull.add_thruster({0, 0, 0}, {0, 0, -1}, 0.05);
  hull.thrust(5000 * kMs, down, 20);
  CHECK(hull.depth(7000 * kMs) > 0.3);
  hull.thrust(7000 * kMs, down, 0);
  CHECK(hull.depth(60'000 * kMs) < 0.05);  // positive buoyancy brings it back
  const auto left = hull.add_thruster({0, 0.1, 0}, {1, 0, 0}, 0.05);
  hull.thrust(60'000 * kMs, left, 1);
  CHECK(hull.motion(60'500 * kMs).rate.z() < -0.05);  // pushes forward on the left: turns to the right
  hull.thrust(60'500 * kMs, left, 0);
  hull.disturb(60'500 * kMs, Eigen::Vector3d::Zero(), {0.2, 0, 0});
  CHECK(angles_of(hull.motion(65'000 * kMs).attitude).roll > 10 * kDegree);
  hull.disturb(65'000 * kMs, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  CHECK(angles_of(hull.motion(80'000 * kMs).attitude).roll == Approx(0).margin(1 * kDegree));
}
