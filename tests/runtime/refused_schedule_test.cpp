// A schedule the board cannot run is refused at start, before any bus is touched.
#include "catch.hpp"
#include "finemote/host.hpp"
#include "runtime/src/start.hpp"

namespace {

using namespace finemote;

bool buses_started;
void start_buses() { buses_started = true; }
void nothing() {}

constexpr Bucket good[] = {{nothing, 5'000'000, 48, 4, 3}, {nothing, 10'000'000, 49, 5, 3}};
constexpr Bucket off_tick[] = {{nothing, 5'500'000, 48, 4, 3}};
constexpr Bucket swapped[] = {{nothing, 10'000'000, 48, 4, 3}, {nothing, 5'000'000, 49, 5, 3}};
constexpr Bucket inverted[] = {{nothing, 5'000'000, 48, 5, 3}, {nothing, 10'000'000, 49, 4, 3}};
constexpr Bucket two_words[] = {{nothing, 5'000'000, 48, 4, 3}, {nothing, 10'000'000, 64, 5, 3}};

Schedule with(Buckets buckets, Duration tick = kMillisecond) {
  return {"Refused", tick, buckets, Overrun::skip, start_buses, nothing, nullptr};
}

// Empty when the schedule was accepted.
std::string refusal(const Schedule& schedule) {
  host::reset();
  buses_started = false;
  constexpr detail::ReleaseTimer timer{99 * kMillisecond, 125, true};
  try {
    detail::start_robot(schedule, timer);
  } catch (...) {
    CHECK_FALSE(buses_started);
    return host::stop_text();
  }
  CHECK(buses_started);
  return {};
}

}  // namespace

extern "C" const Schedule finemote_schedule{"Refused", 1'000'000, good, Overrun::skip, start_buses, nothing, nullptr};

TEST_CASE("a schedule that fits the release timer is accepted") {
  CHECK(refusal(with(good)).empty());
  CHECK(refusal(with(off_tick, 500 * kMicrosecond)).empty());
}

TEST_CASE("a schedule the board cannot run is refused with its reason") {
  CHECK(refusal(with({})) == "schedule: no buckets");
  CHECK(refusal(with(good, 0)) == "schedule: this board cannot count the tick");
  CHECK(refusal(with(good, 100 * kMillisecond)) == "schedule: this board cannot count the tick");
  CHECK(refusal(with(good, 333)) == "schedule: this board cannot count the tick");
  CHECK(refusal(with(off_tick)) == "schedule: a period is no multiple of the tick");
  CHECK(refusal(with(swapped)) == "schedule: a shorter period must come first and be more urgent");
  CHECK(refusal(with(inverted)) == "schedule: a shorter period must come first and be more urgent");
  CHECK(refusal(with(two_words)) == "schedule: the lines are not all in one word of the interrupt controller");
}
