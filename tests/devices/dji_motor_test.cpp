// DJI motors: bytes both ways, turns, silence, and current only from fresh data.
#include "finemote/devices/dji_gm6020.hpp"
#include "finemote/devices/dji_m2006.hpp"
#include "finemote/devices/dji_m3508.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;

struct Fixture {
  Fixture() {
    bench::reset();
    bus.start();
  }
  static CanFrame feedback(std::uint16_t id, int angle, int rpm, int current, int temperature) {
    const auto high = [](int x) { return static_cast<std::uint8_t>((x >> 8) & 0xFF); };
    const auto low = [](int x) { return static_cast<std::uint8_t>(x & 0xFF); };
    return {id, 8, {high(angle), low(angle), high(rpm), low(rpm), high(current), low(current), low(temperature), 0}};
  }
  void receive(const CanFrame& frame, Duration after = kMillisecond) {
    host::can1.feed(now() + after, frame);
    host::advance(after + 1);
    for (DjiMotor* motor :
         {static_cast<DjiMotor*>(&wheel), static_cast<DjiMotor*>(&fifth), static_cast<DjiMotor*>(&yaw)}) {
      motor->update();
    }
  }
  void command(DjiMotor& motor, float torque, Duration age = 0) {
    motor.command.torque = torque;
    motor.command.origin = now() - age;
    motor.command.valid = true;
    motor.handle();
  }
  /// What the bus sends at a flush: identifier and four words each.
  std::vector<std::vector<int>> flush() {
    host::can1.sent.clear();
    bus.flush();
    host::advance(2 * kMillisecond);
    std::vector<std::vector<int>> all;
    for (const CanHardware::Sent& sent : host::can1.sent) {
      std::vector<int> words{sent.frame.id};
      for (int i = 0; i < 4; ++i) {
        words.push_back(static_cast<std::int16_t>(sent.frame.data[2 * i] << 8 | sent.frame.data[2 * i + 1]));
      }
      all.push_back(words);
    }
    std::sort(all.begin(), all.end());  // which leaves first is the mailboxes' affair
    return all;
  }

  CanSlot wheel_slot{bus, 2, 0x202, CanSlot::kAnyTime, 1, CanShare{0x200, 2, 2}};
  CanSlot fifth_slot{bus, 5, 0x205, CanSlot::kAnyTime, 1, CanShare{0x1FF, 0, 2}};
  CanSlot yaw_slot{bus, 3, 0x207, CanSlot::kAnyTime, 1, CanShare{0x1FE, 4, 2}};
  CanSlot* const table[3] = {&wheel_slot, &fifth_slot, &yaw_slot};
  CanBus bus{ports::can1, 1000000, table};
  DjiM3508 wheel{{}, wheel_slot};
  DjiM2006 fifth{{}, fifth_slot};
  DjiGm6020 yaw{{}, yaw_slot};
};

constexpr double kPi = 3.14159265358979;

}  // namespace

TEST_CASE_METHOD(Fixture, "feedback becomes angle, speed and torque at the output shaft") {
  receive(feedback(0x202, 4096, 1920, 8192, 45));
  CHECK(wheel.state.valid);
  CHECK(wheel.state.angle == Approx(kPi / 19.2032).epsilon(1e-4));
  CHECK(wheel.state.speed == Approx(1920 * 2 * kPi / 60 / 19.2032).epsilon(1e-4));
  CHECK(wheel.state.torque == Approx(3.0).epsilon(1e-4));  // 10 A at 0.3 N m/A
  CHECK(wheel.state.temperature == 45);
  CHECK(wheel.state.origin == 1 * kMillisecond - 135 * kMicrosecond);  // the longest frame
  CHECK_FALSE(wheel.state.unreachable);
  CHECK_FALSE(fifth.state.valid);
  receive(feedback(0x207, 2048, -60, -8192, 30));
  CHECK(yaw.state.angle == Approx(kPi / 2).epsilon(1e-4));
  CHECK(yaw.state.speed == Approx(-2 * kPi).epsilon(1e-4));
  CHECK(yaw.state.torque == Approx(-1.5 * 0.741).epsilon(1e-4));
}

TEST_CASE_METHOD(Fixture, "a C610 tells no temperature: the byte for it is not taken") {
  receive(feedback(0x205, 4096, 0, 0, 45));
  CHECK(fifth.state.valid);
  CHECK(fifth.state.temperature == 0);
}

TEST_CASE_METHOD(Fixture, "angles count from where the encoder's zero is said to be") {
  const auto first = [&](int reading) {
    DjiGm6020 motor{{3.0F}, yaw_slot};
    host::can1.feed(now() + kMillisecond, feedback(0x207, reading, 0, 0, 30));
    host::advance(kMillisecond + 1);
    motor.update();
    return static_cast<double>(motor.state.angle);
  };
  CHECK(first(static_cast<int>(3.0 / (2 * kPi) * 8192)) == Approx(0).margin(1e-3));
  CHECK(first(0) == Approx(-3).margin(1e-3));
  CHECK(first(8191) == Approx(-3).margin(2e-3));
  CHECK(first(8000) == Approx(2 * kPi * 8000 / 8192 - 3).margin(1e-3));
}

TEST_CASE_METHOD(Fixture, "turns are counted both ways, and at more than half a turn per update") {
  receive(feedback(0x207, 8000, 0, 0, 30));
  CHECK(yaw.state.angle == Approx(-2 * kPi * 192 / 8192).epsilon(1e-5));  // a little below zero, not a turn above it
  receive(feedback(0x207, 100, 10, 0, 30));
  CHECK(yaw.state.angle == Approx(2 * kPi * 100 / 8192).epsilon(1e-5));
  receive(feedback(0x207, 8000, -10, 0, 30));
  CHECK(yaw.state.angle == Approx(-2 * kPi * 192 / 8192).epsilon(1e-5));
  receive(feedback(0x207, 4000, -9000, 0, 30));
  receive(feedback(0x207, 8100, -9000, 0, 30));
  CHECK(yaw.state.angle < -2 * kPi * 92 / 8192);
  // 9000 rpm, seen every 10 ms: one and a half turns in between.
  double turns = 0;
  receive(feedback(0x202, 0, 9000, 0, 30));
  for (int i = 0; i < 50; ++i) {
    turns += 9000.0 / 60 * 0.010;
    receive(feedback(0x202, static_cast<int>(std::fmod(turns, 1) * 8192), 9000, 0, 30), 10 * kMillisecond - 1);
  }
  CHECK(wheel.state.angle == Approx(turns * 2 * kPi / 19.2032).epsilon(1e-3));
}

TEST_CASE_METHOD(Fixture, "four motors share a frame; the word is at the place of the id") {
  command(wheel, 3);      // 10 A
  command(fifth, -0.9F);  // -5 A
  command(yaw, 0.741F);   // 1 A
  CHECK(flush() ==
        std::vector<std::vector<int>>{{0x1FE, 0, 0, 5461, 0}, {0x1FF, -5000, 0, 0, 0}, {0x200, 0, 8192, 0, 0}});
  CHECK(flush().empty());
}

TEST_CASE_METHOD(Fixture, "torque beyond the controller's range is cut") {
  command(wheel, 1000);
  command(fifth, -1000);
  CHECK(flush() == std::vector<std::vector<int>>{{0x1FF, -10000, 0, 0, 0}, {0x200, 0, 16384, 0, 0}});
}

TEST_CASE_METHOD(Fixture, "old, invalid and impossible commands give no current; safe() too") {
  host::advance(1 * kSecond);
  const auto driven = [&] { return flush().at(0).at(2); };
  command(wheel, 3);
  CHECK(driven() == 8192);
  command(wheel, 3, 100 * kMillisecond + 1);
  CHECK(driven() == 0);
  command(wheel, 3);
  CHECK(driven() == 8192);
  command(wheel, NAN);
  CHECK(driven() == 0);
  command(wheel, 3);
  wheel.safe();
  CHECK(driven() == 0);
  command(wheel, 3);
  wheel.command.valid = false;
  wheel.handle();
  CHECK(driven() == 0);
}

TEST_CASE_METHOD(Fixture, "a motor that falls silent is invalid and unreachable after 20 ms, and stays so") {
  receive(feedback(0x202, 100, 0, 0, 30));
  host::advance(19 * kMillisecond);
  wheel.update();
  CHECK(wheel.state.valid);
  host::advance(2 * kMillisecond);
  wheel.update();
  CHECK_FALSE(wheel.state.valid);
  CHECK(wheel.state.unreachable);
  host::advance(60 * kSecond);
  wheel.update();
  CHECK_FALSE(wheel.state.valid);
  CHECK(wheel.state.origin == 1 * kMillisecond - 135 * kMicrosecond);  // the longest frame
  receive(feedback(0x202, 100, 0, 0, 30));
  CHECK(wheel.state.valid);
}

TEST_CASE_METHOD(Fixture,
                 "behind a silence a motor without gear is where its encoder says, whatever its speed is by then") {
  const auto after_silence = [&](DjiMotor& motor, std::uint16_t id, int rpm) {
    receive(feedback(id, 4000, 0, 0, 30));
    const float before = motor.state.angle;
    for (int i = 0; i < 90; ++i) {
      host::advance(10 * kMillisecond);
      motor.update();
    }
    receive(feedback(id, 4300, rpm, 0, 30));
    CHECK(motor.state.valid);
    return static_cast<double>(motor.state.angle - before);
  };
  CHECK(after_silence(yaw, 0x207, 80) == Approx(2 * kPi * 300 / 8192).epsilon(1e-3));
  CHECK(after_silence(wheel, 0x202, 80) == Approx(2 * kPi * (1 + 300.0 / 8192) / 19.2032).epsilon(1e-3));  // 0.6 turns
}

TEST_CASE_METHOD(Fixture, "turns are counted by the mean of two speeds") {
  receive(feedback(0x202, 0, 6000, 0, 30));
  receive(feedback(0x202, 4096, 0, 0, 30), 15 * kMillisecond - 1);  // 0.75 turns by the mean, 1.5 or none by either
  CHECK(wheel.state.angle == Approx(2 * kPi * 0.5 / 19.2032).epsilon(1e-3));
}

TEST_CASE_METHOD(Fixture, "impossible feedback is not taken") {
  receive(feedback(0x202, 8192, 0, 0, 30));
  CHECK_FALSE(wheel.state.valid);
  CanFrame brief = feedback(0x202, 100, 0, 0, 30);
  brief.size = 6;
  receive(brief);
  CHECK_FALSE(wheel.state.valid);
}
