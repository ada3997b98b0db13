// H30: frames byte by byte, wrong sums, noise, silence.
#include "finemote/devices/h30_imu.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"
#include "runtime/boards/host/ports/h30_part.hpp"

namespace {

using namespace finemote;
using Bytes = std::vector<std::uint8_t>;

/// Made by hand from the description in the header; sums computed apart from the driver.
const Bytes kFrame{
    0x59, 0x53, 0x01, 0x00, 0x2A,                                                        //
    0x10, 0x0C, 0x40, 0x42, 0x0F, 0x00, 0x80, 0x84, 0x1E, 0x00, 0xC0, 0xBD, 0xF0, 0xFF,  // 1, 2, -1 m/s^2
    0x20, 0x0C, 0x80, 0x96, 0x98, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x69, 0x67, 0xFF,  // 10, 0, -10 deg/s
    0x40, 0x0C, 0x80, 0x96, 0x98, 0x00, 0x00, 0x2D, 0x31, 0x01, 0x00, 0x5A, 0x62, 0x02,  // 10, 20, 40 deg
    0,    0};

Bytes with_sums(Bytes frame) {
  unsigned a = 0, b = 0;
  for (std::size_t i = 2; i + 2 < frame.size(); ++i) {
    a += frame[i];
    b += a;
  }
  frame[frame.size() - 2] = static_cast<std::uint8_t>(a);
  frame[frame.size() - 1] = static_cast<std::uint8_t>(b);
  return frame;
}

struct Fixture {
  Fixture() {
    bench::reset();
    uart.start();
  }
  void receive(const Bytes& bytes) {
    host::usart1.feed(now(), bytes);
    host::advance(5 * kMillisecond);
    imu.update();
  }
  std::uint8_t ring[256];
  Uart uart{ports::usart1, 921600, ring};
  H30Imu imu{nullptr, uart};
};

constexpr float kDegree = 0.0174532925F;

}  // namespace

TEST_CASE_METHOD(Fixture, "a frame becomes attitude, rates and acceleration") {
  const Bytes frame = with_sums(kFrame);
  CHECK(frame[frame.size() - 2] == 0xA6);
  CHECK(frame[frame.size() - 1] == 0xB9);
  receive(frame);
  CHECK(imu.frames() == 1);
  CHECK(imu.state.valid);
  CHECK(imu.state.acceleration[0] == Approx(1));
  CHECK(imu.state.acceleration[1] == Approx(2));
  CHECK(imu.state.acceleration[2] == Approx(-1));
  CHECK(imu.state.rate[0] == Approx(10 * kDegree));
  CHECK(imu.state.rate[2] == Approx(-10 * kDegree));
  CHECK(imu.state.pitch == Approx(10 * kDegree));
  CHECK(imu.state.roll == Approx(20 * kDegree));
  CHECK(imu.state.yaw == Approx(40 * kDegree));
  constexpr Duration kFilter = 1 * kMillisecond;  // `latency_ns` of the descriptor
  CHECK(imu.state.origin <= -kFilter);            // it began to arrive at 0
  CHECK(imu.state.origin > -kFilter - 100 * kMicrosecond);
}

namespace {

/// m/s^2, deg/s and deg, as the part says them.
Bytes frame_of(const float (&acceleration)[3], const float (&rate_deg)[3], const float (&pitch_roll_yaw)[3]) {
  Bytes frame = kFrame;
  const auto put = [&](std::size_t at, float value) {
    const auto word = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(double{value} * 1e6)));
    for (unsigned byte = 0; byte < 4; ++byte) frame[at + byte] = static_cast<std::uint8_t>(word >> 8 * byte);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    put(7 + 4 * i, acceleration[i]);
    put(21 + 4 * i, rate_deg[i]);
    put(35 + 4 * i, pitch_roll_yaw[i]);
  }
  return with_sums(frame);
}

/// By quaternions, another way than the driver's.
struct Quaternion {
  double w, x, y, z;
  friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
  [[nodiscard]] Quaternion back() const { return {w, -x, -y, -z}; }
  static Quaternion of(double roll, double pitch, double yaw) {
    const Quaternion r{std::cos(roll / 2), std::sin(roll / 2), 0, 0}, p{std::cos(pitch / 2), 0, std::sin(pitch / 2), 0},
        y{std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)};
    return y * p * r;
  }
  [[nodiscard]] double roll() const { return std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)); }
  [[nodiscard]] double pitch() const { return std::asin(2 * (w * y - z * x)); }
  [[nodiscard]] double yaw() const { return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)); }
  [[nodiscard]] Quaternion turn(const float (&v)[3]) const { return *this * Quaternion{0, v[0], v[1], v[2]} * back(); }
};

}  // namespace

TEST_CASE_METHOD(Fixture, "attitude, rates and acceleration are those of the robot, however the part is mounted") {
  std::mt19937 random(21);
  std::uniform_real_distribution<float> any(-1, 1);
  const float turns[][3] = {{0, 0, 90}, {180, 0, 0}, {-90, 0, 0}, {0, 90, 0}, {0, -90, 180}, {30, -20, 100}};
  for (const auto& turned : turns) {
    const Quaternion mounting =
        Quaternion::of(double{turned[0] * kDegree}, double{turned[1] * kDegree}, double{turned[2] * kDegree});
    const Rotation mount = Rotation::of_angles(turned[0] * kDegree, turned[1] * kDegree, turned[2] * kDegree);
    H30Imu imu_there{&mount, uart};
    for (int round = 0; round < 50; ++round) {
      const float roll = 170 * any(random), pitch = 80 * any(random), yaw = 170 * any(random);
      const Quaternion robot = Quaternion::of(double{roll * kDegree}, double{pitch * kDegree}, double{yaw * kDegree});
      const Quaternion part = robot * mounting;
      const float acceleration[3] = {any(random), any(random), 9.8F}, rate[3] = {any(random), 40 * any(random), 1};
      const Quaternion felt = mounting.back().turn(acceleration), turning = mounting.back().turn(rate);
      const auto degrees = [](double angle) { return static_cast<float>(angle / M_PI * 180); };
      const auto as_float = [](double value) { return static_cast<float>(value); };
      host::usart1.feed(now(), frame_of({as_float(felt.x), as_float(felt.y), as_float(felt.z)},
                                        {as_float(turning.x), as_float(turning.y), as_float(turning.z)},
                                        {degrees(part.pitch()), degrees(part.roll()), degrees(part.yaw())}));
      host::advance(5 * kMillisecond);
      imu_there.update();
      imu_there.update();  // nothing new: it stays as it is
      const auto& state = imu_there.state;
      REQUIRE(state.valid);
      INFO(turned[0] << " " << turned[1] << " " << turned[2] << ": " << roll << " " << pitch << " " << yaw);
      CHECK(state.roll == Approx(roll * kDegree).margin(2e-3));
      CHECK(state.pitch == Approx(pitch * kDegree).margin(1e-3));
      CHECK(state.yaw == Approx(yaw * kDegree).margin(2e-3));
      for (int i = 0; i < 3; ++i) {
        CHECK(state.acceleration[i] == Approx(acceleration[i]).margin(1e-4));
        CHECK(state.rate[i] == Approx(rate[i] * kDegree).margin(1e-5));
      }
    }
  }
}

TEST_CASE_METHOD(Fixture, "every single wrong bit is seen") {
  const Bytes good = with_sums(kFrame);
  for (std::size_t i = 2; i < good.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      bench::reset();
      Uart line{ports::usart1, 921600, ring};
      line.start();
      H30Imu other{nullptr, line};
      Bytes bad = good;
      bad[i] ^= static_cast<std::uint8_t>(1 << bit);
      host::usart1.feed(0, bad);
      host::advance(5 * kMillisecond);
      other.update();
      CHECK(other.frames() == 0);
      CHECK_FALSE(other.state.valid);
    }
  }
}

TEST_CASE_METHOD(Fixture, "frames split over updates, joined, and between noise are all found") {
  const Bytes frame = with_sums(kFrame);
  for (std::size_t cut = 1; cut < frame.size(); ++cut) {
    receive(Bytes(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(cut)));
    receive(Bytes(frame.begin() + static_cast<std::ptrdiff_t>(cut), frame.end()));
  }
  CHECK(imu.frames() == frame.size() - 1);
  Bytes mixed{0x59, 0x59, 0x53, 0xFF, 0x59};
  for (int i = 0; i < 2; ++i) mixed.insert(mixed.end(), frame.begin(), frame.end());
  mixed.push_back(0x59);
  receive(mixed);
  receive(frame);
  CHECK(imu.frames() == frame.size() - 1 + 3);
}

TEST_CASE_METHOD(Fixture, "a wrong frame does not hide the right one behind it") {
  Bytes bytes = with_sums(kFrame);
  bytes[10] ^= 1;
  const Bytes good = with_sums(kFrame);
  bytes.insert(bytes.end(), good.begin(), good.end());
  receive(bytes);
  CHECK(imu.frames() == 1);
  CHECK(imu.bad_frames() >= 1);
}

TEST_CASE_METHOD(Fixture, "values out of range and missing records are no frame, whatever the sums say") {
  Bytes steep = kFrame;
  steep[kFrame.size() - 14] = 0x00;  // pitch: 100 degrees
  steep[kFrame.size() - 13] = 0xE1;
  steep[kFrame.size() - 12] = 0xF5;
  steep[kFrame.size() - 11] = 0x05;
  receive(with_sums(steep));
  CHECK(imu.frames() == 0);
  Bytes partial = kFrame;
  partial[5 + 14] = 0x21;  // no rates
  receive(with_sums(partial));
  CHECK(imu.frames() == 0);
  Bytes overlong = kFrame;
  overlong[6 + 28] = 0x0D;  // the last record reaches beyond the frame
  receive(with_sums(overlong));
  CHECK(imu.frames() == 0);
}

TEST_CASE_METHOD(Fixture, "any bytes at all leave it able to read the next frame") {
  std::uint32_t random = 1;
  for (int round = 0; round < 200; ++round) {
    Bytes noise;
    for (int i = 0; i < 120; ++i) {
      random = random * 1664525 + 1013904223;
      const auto byte = static_cast<std::uint8_t>(random >> 24);
      noise.push_back(byte < 40 ? 0x59 : byte < 60 ? 0x53 : byte);
    }
    receive(noise);
  }
  const std::uint32_t before = imu.frames();
  const Bytes frame = with_sums(kFrame);
  for (int i = 0; i < 5; ++i) receive(frame);
  CHECK(imu.frames() >= before + 3);
  CHECK(imu.state.valid);
}

TEST_CASE_METHOD(Fixture, "a sensor that falls silent is invalid after 50 ms and stays old for a minute") {
  host::H30Part part{host::usart1, 0, 5 * kMillisecond};
  part.state.roll = 0.5F;
  for (int i = 0; i < 100; ++i) {
    host::advance(5 * kMillisecond);
    imu.update();
    if (i > 1) {
      REQUIRE(imu.state.valid);
      REQUIRE(now() - imu.state.origin <= 12 * kMillisecond);
    }
  }
  CHECK(imu.state.roll == Approx(0.5));
  part.silent = true;
  host::advance(60 * kMillisecond);
  imu.update();
  imu.update();
  CHECK_FALSE(imu.state.valid);
  const Time origin = imu.state.origin;
  for (int i = 0; i < 12000; ++i) {
    host::advance(5 * kMillisecond);
    imu.update();
  }
  CHECK_FALSE(imu.state.valid);
  CHECK(imu.state.origin == origin);
  part.silent = false;
  host::advance(20 * kMillisecond);
  imu.update();
  CHECK(imu.state.valid);
}

TEST_CASE_METHOD(Fixture, "a sensor in noise is invalid") {
  host::H30Part part{host::usart1, 0, 5 * kMillisecond};
  part.noisy = true;
  for (int i = 0; i < 100; ++i) {
    host::advance(5 * kMillisecond);
    imu.update();
    REQUIRE_FALSE(imu.state.valid);
  }
  CHECK(imu.bad_frames() > 50);
}

TEST_CASE_METHOD(Fixture, "a frame with both records of the magnetometer counts") {
  Bytes frame(kFrame.begin(), kFrame.end() - 2);
  for (const std::uint8_t type : {0x30, 0x31, 0x41}) {
    const std::uint8_t length = type == 0x41 ? 16 : 12;
    frame.push_back(type);
    frame.push_back(length);
    frame.insert(frame.end(), length, type);
  }
  frame[4] = static_cast<std::uint8_t>(frame.size() - 5);
  REQUIRE(frame[4] == 88);
  frame.insert(frame.end(), 2, 0);
  receive(with_sums(frame));
  CHECK(imu.frames() == 1);
  CHECK(imu.state.yaw == Approx(40 * kDegree));
}

TEST_CASE_METHOD(Fixture,
                 "many beginnings with wrong sums are not summed again and again, and hide one frame at most") {
  Bytes bytes;
  while (bytes.size() < 200) bytes.insert(bytes.end(), {0x59, 0x53, 0, 0, 0x58});
  receive(bytes);
  CHECK(imu.bad_frames() <= 5);
  receive(with_sums(kFrame));
  receive(with_sums(kFrame));
  receive(with_sums(kFrame));
  CHECK(imu.frames() >= 1);
}
