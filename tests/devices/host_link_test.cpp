// The link's own pace: frames are due on a grid, whatever the start of a job varies by. tests/link has the rest.
#include "finemote/devices/host_link.hpp"

#include <random>
#include <vector>

#include "catch.hpp"
#include "finemote/bench/bench.hpp"

namespace {

using namespace finemote;

struct Paced {
  explicit Paced(Duration interval) : link{{200 * kMillisecond, interval}, layout, uart} {
    bench::reset();
    uart.start();
  }
  /// Frames of `jobs` jobs, each at its release and a delay that changes.
  std::size_t sent(Duration period, int jobs) {
    const Duration delays[] = {90 * kMicrosecond, 0, 130 * kMicrosecond, 10 * kMicrosecond, 70 * kMicrosecond};
    for (int job = 0; job < jobs; ++job) {
      host::advance(job * period + delays[job % 5] - now());
      link.update();
      link.handle();
    }
    return host::usart6.sent.size();
  }
  const Stamp stamp{};
  const LinkSource source[1]{{stamp, {}, 0}};
  const LinkLayout layout{1, {source, 1}, {}, 1, 0};
  std::uint8_t ring[256];
  Uart uart{ports::usart6, 921600, ring};
  HostLink link;
};

}  // namespace

TEST_CASE("a frame in every job, although jobs begin sooner or later after their release") {
  CHECK(Paced(10 * kMillisecond).sent(10 * kMillisecond, 200) == 200);
  CHECK(Paced(5 * kMillisecond).sent(10 * kMillisecond, 200) == 200);
}

TEST_CASE("an interval that is no multiple of the period holds on average") {
  const std::size_t frames = Paced(25 * kMillisecond).sent(10 * kMillisecond, 200);
  CHECK(frames >= 79);
  CHECK(frames <= 80);
}

TEST_CASE("after a pause there is no burst") {
  Paced link(10 * kMillisecond);
  CHECK(link.sent(10 * kMillisecond, 1) == 1);
  host::advance(1 * kSecond);
  link.link.update();
  host::advance(3 * kMillisecond);
  link.link.update();
  CHECK(host::usart6.sent.size() == 2);
}

namespace {

using Bytes = std::vector<std::uint8_t>;

/// A link whose computer commands one number.
struct Commanded {
  Commanded() {
    bench::reset();
    uart.start();
  }
  static Bytes frame(std::uint16_t number, std::uint32_t layout = 7) {
    Bytes bytes{link::kFirst, link::kSecond, link::kCommands << 4U, 3};
    for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(layout >> shift));
    bytes.push_back(0);  // sequence
    bytes.push_back(1);  // valid
    bytes.push_back(static_cast<std::uint8_t>(number & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(number >> 8U));
    const std::uint16_t sum = link::crc(bytes.data() + 2, bytes.size() - 2);
    bytes.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(sum >> 8U));
    return bytes;
  }
  void update_after(const Bytes& bytes) {
    host::usart6.feed(now(), bytes);
    host::advance(10 * kMillisecond);
    host_link.update();
  }

  Stamp stamp{};
  std::uint16_t number = 0;
  const LinkSlot slot[1]{{LinkKind::kU16, &number}};
  const LinkTarget target[1]{{stamp, {slot, 1}, 0}};
  const LinkLayout layout{7, {}, {target, 1}, 0, 1};
  std::uint8_t ring[256];
  Uart uart{ports::usart6, 921600, ring};
  HostLink host_link{{}, layout, uart};
};

void append(Bytes& to, const Bytes& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace

TEST_CASE("the sum of a frame is that of the standard's example") {
  const std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  CHECK(link::crc(digits, sizeof digits) == 0x29B1);
}

TEST_CASE("of several frames in one update the last counts, and each is counted") {
  Commanded robot;
  Bytes burst;
  for (std::uint16_t number = 1; number <= 15; ++number) append(burst, Commanded::frame(number));
  robot.update_after(burst);
  CHECK(robot.number == 15);
  CHECK(robot.host_link.state.frames == 15);
  CHECK(robot.stamp.valid);
}

TEST_CASE("no update shows a command as valid that is too old by then") {
  Commanded link;
  link.update_after(Commanded::frame(1));
  REQUIRE(link.host_link.state.valid);
  host::usart6.feed(now(), Commanded::frame(2));
  host::advance(1 * kSecond);
  link.host_link.update();
  CHECK(link.number == 2);
  CHECK_FALSE(link.host_link.state.valid);
  CHECK_FALSE(link.stamp.valid);
}

TEST_CASE("a frame is found between any bytes, and across updates wherever they cut it") {
  std::mt19937 dice(3);
  Commanded robot;
  std::uint32_t frames = 0;
  for (std::uint16_t number = 1; number <= 400; ++number) {
    Bytes bytes;
    const std::size_t noise = dice() % 20;
    for (std::size_t i = 0; i < noise; ++i) bytes.push_back(static_cast<std::uint8_t>(dice() % 3 == 0 ? 0xA5 : dice()));
    append(bytes, Commanded::frame(number));
    const std::size_t cut = dice() % bytes.size();
    robot.update_after({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(cut)});
    robot.update_after({bytes.begin() + static_cast<std::ptrdiff_t>(cut), bytes.end()});
    robot.update_after(Bytes(120, 0));  // what noise that began as a frame waits for
    CAPTURE(number, noise, cut);
    CHECK(robot.number == number);
    CHECK(robot.host_link.state.frames == ++frames);
  }
}

TEST_CASE("damaged frames and frames of another layout change nothing, and the good one behind them counts") {
  Commanded robot;
  Bytes damaged = Commanded::frame(1), bytes = Commanded::frame(2, 8);
  damaged[10] ^= 1U;
  append(bytes, damaged);
  robot.update_after(bytes);
  CHECK(robot.number == 0);
  CHECK(robot.host_link.state.mismatched == 1);
  CHECK(robot.host_link.state.rejected == 1);
  append(bytes, Commanded::frame(3));
  robot.update_after(bytes);
  CHECK(robot.number == 3);
  CHECK(robot.host_link.state.frames == 1);
}

TEST_CASE("bytes full of false beginnings are summed about once") {
  Commanded robot;
  const Bytes frame = Commanded::frame(1);
  constexpr std::size_t kHeader = 9, kTolerated = 2;
  Bytes bytes;
  for (int i = 0; i < 24; ++i) append(bytes, {frame.begin(), frame.begin() + kHeader});
  robot.update_after(bytes);
  const std::size_t rejected = robot.host_link.state.rejected;
  CAPTURE(rejected);
  CHECK(rejected > kTolerated);
  CHECK(rejected * frame.size() <= bytes.size() + kTolerated * frame.size());
  robot.update_after(Bytes(120, 0));
  robot.update_after(frame);
  CHECK(robot.number == 1);
}
