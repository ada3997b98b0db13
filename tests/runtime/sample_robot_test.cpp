// A robot of two periods runs on the host board in the order of its schedule.
#include <sstream>
#include <string>

#include "catch.hpp"
#include "finemote/host.hpp"
#include "finemote/schedule.hpp"

namespace {

using namespace finemote;

// "0@0-200 1@200-300": stage, start and end in us; a preempted stage ends later than it began plus its work.
std::string stages_before(Time limit) {
  std::ostringstream text;
  for (const host::Event& event : host::events()) {
    if (event.at < limit) text << event.stage << (event.end ? "E" : "B") << event.at / kMicrosecond << ' ';
  }
  return text.str();
}

}  // namespace

TEST_CASE("updates run leaf to root, handles root to leaf, and the fast bucket preempts the slow one") {
  host::reset();
  REQUIRE(host::run(20 * kMillisecond));
  CHECK(stages_before(10 * kMillisecond) ==
        "0B0 0E200 1B200 1E300 "                      // 5 ms bucket
        "2B300 2E1300 4B1300 4E2300 6B2300 6E4300 "   // 10 ms bucket: updates
        "7B4300 0B5000 0E5200 1B5200 1E5300 7E5600 "  // root handle, preempted at 5 ms
        "5B5600 5E6100 3B6100 3E6600 ");
  CHECK(overruns(0) == 0);
  CHECK(overruns(1) == 0);
  CHECK(host::watchdog_fed());
}

TEST_CASE("two runs record the same events") {
  host::reset();
  REQUIRE(host::run(100 * kMillisecond));
  const std::string first = stages_before(100 * kMillisecond);
  host::reset();
  REQUIRE(host::run(100 * kMillisecond));
  CHECK(stages_before(100 * kMillisecond) == first);
}

TEST_CASE("an interrupt at the instant a stage ends comes after the stage and before the next one") {
  host::reset();
  std::size_t seen = 0;
  host::interrupt_at(200 * kMicrosecond, [&] { seen = host::events().size(); });
  REQUIRE(host::run(5 * kMillisecond));
  CHECK(seen == 2);  // 0B 0E
}
