// The link's own pace: frames are due on a grid, whatever the start of a job varies by. tests/link has the rest.
#include "finemote/devices/host_link.hpp"

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
