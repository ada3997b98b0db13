// DR16 and SBUS: bits of the frames, disturbed ones, silence.
#include "finemote/devices/dr16.hpp"
#include "finemote/devices/sbus.hpp"

#include <algorithm>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

/// Sets 11 bits, least significant first.
void put(Bytes& bytes, unsigned at, unsigned value) {
  for (unsigned bit = 0; bit < 11; ++bit) {
    const unsigned n = at + bit;
    bytes[n / 8] = static_cast<std::uint8_t>((bytes[n / 8] & ~(1U << n % 8)) | (value >> bit & 1U) << n % 8);
  }
}

Bytes dr16_frame(const std::vector<unsigned>& channels, unsigned left, unsigned right) {
  Bytes frame(18);
  for (unsigned i = 0; i < 4; ++i) put(frame, 11 * i, channels[i]);
  frame[5] = static_cast<std::uint8_t>((frame[5] & 0x0F) | left << 6 | right << 4);
  return frame;
}

Bytes sbus_frame(const std::vector<unsigned>& channels, unsigned flags = 0) {
  Bytes frame(25);
  frame[0] = 0x0F;
  for (unsigned i = 0; i < 16; ++i) put(frame, 8 + 11 * i, i < channels.size() ? channels[i] : 992);
  frame[23] = static_cast<std::uint8_t>(flags);
  return frame;
}

template <class Device>
struct Fixture {
  explicit Fixture(UartFormat format) : uart(ports::usart3, 100000, ring, format) {
    bench::reset();
    uart.start();
  }
  void receive(const Bytes& bytes) {
    host::usart3.feed(now(), bytes);
    for (int i = 0; i < 14; ++i) {
      host::advance(1 * kMillisecond);
      device.update();
    }
  }
  std::uint8_t ring[256];
  Uart uart;
  Device device{uart};
};
struct Dr16Fixture : Fixture<Dr16> {
  Dr16Fixture() : Fixture(UartFormat::k8E1Inverted) {}
};
struct SbusFixture : Fixture<Sbus> {
  SbusFixture() : Fixture(UartFormat::k8E2Inverted) {}
};

}  // namespace

TEST_CASE_METHOD(Dr16Fixture, "DR16: sticks, switches, mouse and keys") {
  Bytes frame = dr16_frame({1684, 364, 1024, 1354}, 1, 3);
  frame[6] = 0x10;  // mouse x 16
  frame[8] = 0xFE;  // mouse y -2
  frame[9] = 0xFF;
  frame[13] = 1;     // right button
  frame[14] = 0x05;  // W and A
  frame[16] = 0x00;  // wheel 1024
  frame[17] = 0x04;
  receive(frame);
  const RemoteState& s = device.state;
  CHECK(s.valid);
  CHECK(s.right_x == Approx(1));
  CHECK(s.right_y == Approx(-1));
  CHECK(s.left_x == Approx(0).margin(1e-6));
  CHECK(s.left_y == Approx(0.5));
  CHECK(s.left_switch == RemoteSwitch::kUp);
  CHECK(s.right_switch == RemoteSwitch::kMiddle);
  CHECK(s.mouse[0] == 16);
  CHECK(s.mouse[1] == -2);
  CHECK_FALSE(s.mouse_left);
  CHECK(s.mouse_right);
  CHECK(s.keys == 5);
  CHECK(s.origin <= 0);
  CHECK(s.origin > -1100 * kMicrosecond);
}

TEST_CASE_METHOD(Dr16Fixture,
                 "DR16: frames of the wrong length, with values out of range or line errors do not count") {
  const Bytes good = dr16_frame({1024, 1024, 1024, 1024}, 1, 1);
  receive(Bytes(good.begin(), good.end() - 1));
  receive(dr16_frame({1685, 1024, 1024, 1024}, 1, 1));
  receive(dr16_frame({1024, 1024, 1024, 363}, 1, 1));
  receive(dr16_frame({1024, 1024, 1024, 1024}, 0, 1));
  host::usart3.disturb(1);
  receive(good);
  CHECK(device.bad_frames() == 5);
  CHECK_FALSE(device.state.valid);
  receive(good);
  CHECK(device.state.valid);
  for (int i = 0; i < 25; ++i) receive(i == 0 ? Bytes(2000, 0x20) : Bytes{});  // a line that never falls silent
  receive(good);
  CHECK(device.bad_frames() >= 6);
  CHECK(device.state.valid);
}

TEST_CASE_METHOD(Dr16Fixture, "DR16: a frame counts when it has ended, though the next one has begun") {
  const Bytes first = dr16_frame({1684, 1024, 1024, 1024}, 1, 3), second = dr16_frame({364, 1024, 1024, 1024}, 1, 3);
  const Duration frame = uart.wire_time(first.size());
  host::usart3.feed(now(), first);
  host::advance(5 * kMillisecond);
  const Time ended = frame;
  host::usart3.feed(now(), second);
  host::advance(frame / 2);
  device.update();
  REQUIRE(device.state.valid);
  CHECK(device.state.right_x > 0.99F);
  CHECK(device.state.origin <= ended - frame);
  CHECK(device.state.origin > ended - frame - uart.wire_time(1));
  host::advance(frame);
  device.update();
  CHECK(device.state.right_x < -0.99F);
}

TEST_CASE_METHOD(Dr16Fixture, "DR16: silence is invalid after 100 ms and stays old") {
  receive(dr16_frame({1024, 1024, 1024, 1024}, 1, 1));
  const Time origin = device.state.origin;
  host::advance(70 * kMillisecond);
  device.update();
  CHECK(device.state.valid);
  host::advance(60 * kSecond);
  device.update();
  CHECK_FALSE(device.state.valid);
  CHECK(device.state.origin == origin);
}

TEST_CASE_METHOD(SbusFixture, "SBUS: channels and switches") {
  receive(sbus_frame({1812, 172, 992, 1402, 191, 1811, 582}));
  const RemoteState& s = device.state;
  CHECK(s.valid);
  CHECK(s.right_x == Approx(1));
  CHECK(s.right_y == Approx(-1));
  CHECK(s.left_y == Approx(0).margin(1e-6));
  CHECK(s.left_x == Approx(0.5));
  CHECK(s.left_switch == RemoteSwitch::kUp);
  CHECK(s.right_switch == RemoteSwitch::kDown);
  CHECK(s.wheel == Approx(-0.5));
}

TEST_CASE_METHOD(SbusFixture, "SBUS: every channel can be read as it came, also of a frame that is no data") {
  std::vector<unsigned> channels;
  for (unsigned n = 1; n <= 16; ++n) channels.push_back(127 * n);
  receive(sbus_frame(channels, 0x02));
  receive(sbus_frame(channels, 0x09));
  CHECK(device.frames() == 2);
  for (unsigned n = 1; n <= 16; ++n) CHECK(device.channel(n) == 127 * n);
  CHECK(device.digital(17));
  CHECK_FALSE(device.digital(18));
  CHECK(device.failsafe());
  CHECK_FALSE(device.frame_lost());
}

TEST_CASE_METHOD(SbusFixture, "SBUS: failsafe and lost frames are no data") {
  receive(sbus_frame({992}, 0x04));
  receive(sbus_frame({992}, 0x08));
  CHECK(device.failsafe());
  CHECK_FALSE(device.state.valid);
  receive(sbus_frame({992}));
  CHECK(device.state.valid);
  CHECK_FALSE(device.failsafe());
  for (int i = 0; i < 10; ++i) receive(sbus_frame({992}, 0x0C));
  CHECK_FALSE(device.state.valid);
}

TEST_CASE_METHOD(SbusFixture, "SBUS: noise before a frame does not hide the next ones") {
  Bytes noisy(17, 0x0F);
  receive(noisy);
  receive(sbus_frame({1812}));
  receive(sbus_frame({1812}));
  CHECK(device.state.valid);
  CHECK(device.state.right_x == Approx(1));
}

TEST_CASE_METHOD(SbusFixture, "SBUS: frames of receivers with telemetry slots end in one of four bytes") {
  for (const std::uint8_t tail : {0x04, 0x14, 0x24, 0x34}) {
    Bytes frame = sbus_frame({1812});
    frame[24] = tail;
    receive(frame);
    CHECK(device.state.valid);
    device.state.valid = false;
  }
  CHECK(device.bad_frames() == 0);
  for (const std::uint8_t tail : {0x01, 0x05, 0x44, 0x84}) {
    Bytes frame = sbus_frame({1812});
    frame[24] = tail;
    receive(frame);
    CHECK_FALSE(device.state.valid);
  }
  CHECK(device.bad_frames() >= 4);
}

TEST_CASE_METHOD(SbusFixture, "SBUS: bytes behind a frame are none") {
  receive(sbus_frame({1812}));
  REQUIRE(device.state.valid);
  device.state.valid = false;
  receive(Bytes(200, 0x00));
  CHECK_FALSE(device.state.valid);
}

TEST_CASE_METHOD(SbusFixture, "SBUS: data that look like a frame are none, whatever was cut before") {
  std::vector<unsigned> channels{992, 992, 992, 992, 992, 992, 992, 1792, 1792, 993};
  Bytes whole = sbus_frame(channels);
  if (GENERATE(false, true)) {  // what stands where a rotated frame would end is a tail of a receiver with telemetry
    whole[9] = 0x04;
    whole[10] = 0x0F;
    for (unsigned n = 0; n < channels.size(); ++n) {
      channels[n] = 0;
      for (unsigned bit = 0; bit < 11; ++bit)
        channels[n] |= (whole[1 + (11 * n + bit) / 8] >> (11 * n + bit) % 8 & 1U) << bit;
    }
  }
  const auto inner = std::find(whole.begin() + 1, whole.end(), std::uint8_t{0x0F});
  REQUIRE(inner != whole.end());
  const Duration period = GENERATE(1 * kMillisecond, 5 * kMillisecond, 7 * kMillisecond, 14 * kMillisecond,
                                   20 * kMillisecond, 50 * kMillisecond);
  CAPTURE(period);
  host::usart3.feed(now(), Bytes(inner, whole.end()));  // its start was lost
  for (int i = 1; i <= 40; ++i) host::usart3.feed(now() + i * 7 * kMillisecond, whole);
  for (Duration passed = 0; passed < 300 * kMillisecond; passed += period) {
    host::advance(period);
    device.update();
    if (passed < 60 * kMillisecond) continue;
    REQUIRE(device.state.valid);
    for (unsigned n = 0; n < channels.size(); ++n) REQUIRE(device.channel(n + 1) == channels[n]);
  }
}

TEST_CASE_METHOD(SbusFixture, "SBUS: many beginnings in a row cost a frame or two and no more") {
  receive(Bytes(200, 0x0F));
  const std::uint32_t bad = device.bad_frames();
  CHECK(bad < 60);
  receive(sbus_frame({1812}));
  receive(sbus_frame({1812}));
  CHECK(device.state.valid);
  CHECK(device.state.right_x == Approx(1));
}
