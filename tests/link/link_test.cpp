// Both ends of a generated link: the robot's code on the host board, the header for the computer in this program.
#include <vector>

#include "buses.hpp"
#include "catch.hpp"
#include "finemote/host.hpp"
#include "host/pilot_link_link.hpp"
#include "runtime/boards/host/ports/pins.hpp"
#include "runtime/boards/host/ports/uart_wire.hpp"
#include "trees/imu.hpp"
#include "trees/pilot_link.hpp"

using namespace finemote;
namespace pc = Linked::pilot_link_link;
namespace robot = Linked::pilot_link;

namespace {

std::vector<std::uint8_t> frame_of(const pc::Commands& commands, std::uint8_t sequence, unsigned block = 0) {
  pc::Frame frame;
  const std::size_t size = pc::make_frame(commands, block, sequence, frame);
  return {frame, frame + size};
}

pc::Commands drive(float effort) {
  pc::Commands commands;
  commands.thruster.valid = commands.tail.valid = commands.lamp.valid = true;
  commands.thruster.effort = effort;
  commands.tail.angle = 0.5F;
  commands.lamp.red = 0.25F;
  return commands;
}

std::uint32_t pulse(const PwmHardware& output) { return output.writes.empty() ? 0 : output.writes.back().pulse; }

/// One run of the robot in virtual time; the whole program has one robot, so that this is one test case.
struct Story {
  std::uint8_t sequence = 0;
  void send_at(Time at, std::vector<std::uint8_t> bytes) {
    host::interrupt_at(at, [bytes] { host::usart6.feed(now(), bytes); });
  }
};

}  // namespace

TEST_CASE("a whole story: commands down, states up, damage, a foreign layout, silence") {
  Story story;
  host::gpio.levels[0] = true;
  ports::gpio.configure(pin_number('A', 0), PinSetting::kInputPullUp);
  host::adc3.codes[8] = 2951;  // 24 V

  // Fresh commands every 50 ms from 100 ms to 300 ms.
  for (Time at = 100 * kMillisecond; at <= 300 * kMillisecond; at += 50 * kMillisecond) {
    story.send_at(at, frame_of(drive(0.5F), story.sequence++));
  }
  host::interrupt_at(90 * kMillisecond, [] {
    CHECK(pulse(host::pwm1) == 1'500'000);
    CHECK_FALSE(robot::pilot_link.state.valid);
  });
  host::interrupt_at(131 * kMillisecond, [] {
    CHECK(pulse(host::pwm1) == 1'700'000);
    CHECK(pulse(host::pwm5) > 1'500'000);
    CHECK(pulse(host::led_red) == 250'000);
    CHECK(robot::pilot_link.state.valid);
    CHECK(robot::thruster.command.origin <= 100 * kMillisecond + kMillisecond);
    CHECK(robot::thruster.command.origin >= 99 * kMillisecond);
  });
  // Between two good frames: noise, one with a flipped bit, one of another layout, one cut off.
  std::vector<std::uint8_t> damaged = frame_of(drive(-1), 77), foreign = frame_of(drive(-1), 78), cut = damaged;
  damaged[14] ^= 0x10U;
  foreign[4] ^= 0x01U;
  const std::uint16_t check = pc::crc(foreign.data() + 2, foreign.size() - 4);
  foreign[foreign.size() - 2] = static_cast<std::uint8_t>(check & 0xFFU);
  foreign[foreign.size() - 1] = static_cast<std::uint8_t>(check >> 8U);
  cut.resize(cut.size() / 2);
  story.send_at(205 * kMillisecond, {0x00, 0xA5, 0xA5, 0x5A, 0xFF, 0xFF, 0x13});
  story.send_at(210 * kMillisecond, damaged);
  story.send_at(215 * kMillisecond, foreign);
  story.send_at(220 * kMillisecond, cut);
  host::interrupt_at(249 * kMillisecond, [] {
    CHECK(robot::pilot_link.state.mismatched == 1);
    CHECK(robot::pilot_link.state.rejected >= 1);
    CHECK(pulse(host::pwm1) == 1'700'000);
  });
  // The frame after the cut one is found all the same, at the latest with the one after it.
  host::interrupt_at(330 * kMillisecond, [] {
    CHECK(robot::pilot_link.state.valid);
    CHECK(pulse(host::pwm1) == 1'700'000);
  });
  // Silence from 300 ms on.
  host::interrupt_at(440 * kMillisecond, [] {
    CHECK(pulse(host::pwm1) == 1'500'000);
    CHECK(pulse(host::pwm5) == 1'500'000);
    CHECK_FALSE(robot::thruster.command.valid);
    CHECK_FALSE(robot::pilot_link.state.valid);
  });
  // And back.
  story.send_at(500 * kMillisecond, frame_of(drive(-0.5F), story.sequence++));
  host::interrupt_at(531 * kMillisecond, [] { CHECK(pulse(host::pwm1) == 1'300'000); });
  // One command is withdrawn alone.
  pc::Commands partly = drive(-0.5F);
  partly.thruster.valid = false;
  story.send_at(560 * kMillisecond, frame_of(partly, story.sequence++));
  host::interrupt_at(591 * kMillisecond, [] {
    CHECK(pulse(host::pwm1) == 1'500'000);
    CHECK(pulse(host::pwm5) > 1'500'000);
  });
  REQUIRE(host::run(600 * kMillisecond));
  INFO("frames " << robot::pilot_link.state.frames << " rejected " << robot::pilot_link.state.rejected);
  CHECK(robot::pilot_link.state.frames >= 6);
  CHECK(robot::pilot_link.state.frames <= 7);

  // What the computer heard.
  pc::Receiver receiver;
  float most = 0;
  for (const host::Sent& sent : host::usart6.sent) {
    for (const std::uint8_t byte : sent.bytes) {
      if (receiver.take(byte)) most = std::max(most, receiver.states().thruster.effort);
    }
  }
  CHECK(receiver.rejected() == 0);
  CHECK(receiver.mismatched() == 0);
  CHECK(receiver.lost() == 0);
  CHECK(receiver.frames() == host::usart6.sent.size());
  CHECK(receiver.frames() >= 50);
  CHECK(most == 0.5F);
  const pc::States& heard = receiver.states();
  CHECK(heard.time >= 580 * kMillisecond);
  CHECK(heard.tail.valid);
  CHECK(heard.tail.angle == 0.5F);
  CHECK(heard.supply.voltage == Approx(24).margin(0.02));
  CHECK(heard.key.valid);
  CHECK_FALSE(heard.key.pressed);
  CHECK_FALSE(heard.imu.valid);  // nobody sends its frames
  CHECK(heard.load.origin > 500 * kMillisecond);
  CHECK(heard.time - heard.supply.origin < 60 * kMillisecond);
}

TEST_CASE("the computer's end leaves out what is damaged, and finds the next frame") {
  REQUIRE(host::usart6.sent.size() > 3);  // of the story before
  const std::vector<std::uint8_t> one = host::usart6.sent[1].bytes, two = host::usart6.sent[2].bytes;
  std::vector<std::uint8_t> stream = one;
  stream.resize(20);
  for (const auto& part : {two, one, two}) stream.insert(stream.end(), part.begin(), part.end());
  for (std::size_t broken = 0; broken < stream.size(); ++broken) {
    std::vector<std::uint8_t> bytes = stream;
    bytes[broken] ^= 0x21U;
    pc::Receiver receiver;
    for (const std::uint8_t byte : bytes) receiver.take(byte);
    for (int i = 0; i < 256; ++i) receiver.take(0);  // what a hanging frame waits for
    INFO("byte " << broken);
    CHECK(receiver.frames() >= 2);
    CHECK(receiver.frames() <= 3);
  }
}
