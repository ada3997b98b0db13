// A bucket that cannot keep its period: counted and skipped, or every actuator made safe; the watchdog starves.
#include <vector>

#include "catch.hpp"
#include "finemote/fault.hpp"
#include "finemote/host.hpp"
#include "finemote/schedule.hpp"
#include "finemote/stage.hpp"

namespace {

using namespace finemote;

Duration fast_work;
Duration slow_work;
unsigned slow_jobs_begun;
unsigned slow_jobs_ended;
unsigned safe_calls;
std::vector<unsigned> hooked;

void fast() {
  {
    Stage<0> stage;
    busy(fast_work);
  }
  complete(0);
}
void slow() {
  ++slow_jobs_begun;
  {
    Stage<1> stage;
    busy(slow_work);
  }
  ++slow_jobs_ended;
  complete(1);
}
void nothing() {}
void safe() { ++safe_calls; }

constexpr Bucket buckets[] = {{fast, 5'000'000, 48, 4, 3}, {slow, 10'000'000, 49, 5, 3}};

void prepare(Duration fast_for, Duration slow_for) {
  host::reset();
  fast_work = fast_for;
  slow_work = slow_for;
  slow_jobs_begun = slow_jobs_ended = safe_calls = 0;
  hooked.clear();
}

}  // namespace

extern "C" void finemote_overrun_hook(unsigned bucket) { hooked.push_back(bucket); }

#ifdef SAFE_STOP

extern "C" const Schedule finemote_schedule{"Late", 1'000'000, buckets, Overrun::safe_stop, nothing, safe, nullptr};

TEST_CASE("an overrun makes the outputs safe and nothing runs any more") {
  prepare(kMillisecond, 9 * kMillisecond);  // 9 ms of work and 2 ms of preemption in a period of 10 ms
  CHECK_FALSE(host::run(100 * kMillisecond));
  CHECK(safe_calls == 2);  // at start, and at the stop
  CHECK(slow_jobs_begun == 1);
  CHECK(slow_jobs_ended == 0);  // the job that overran is never returned to
  CHECK(now() == 10 * kMillisecond);
  CHECK(host::stop_text() == "schedule: a bucket overran");
  CHECK(hooked == std::vector<unsigned>{1});
}

#else

extern "C" const Schedule finemote_schedule{"Late", 1'000'000, buckets, Overrun::skip, nothing, safe, nullptr};

TEST_CASE("an overrun is counted, the hook is called, and the running job is left alone") {
  prepare(kMillisecond, 9 * kMillisecond);  // response 11 ms: every second release finds the job running
  const auto before = fault_count(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun));
  REQUIRE(host::run(100 * kMillisecond));
  CHECK(overruns(0) == 0);
  CHECK(overruns(1) == 5);  // at 10, 30, 50, 70, 90 ms
  CHECK(slow_jobs_begun == 5);
  CHECK(slow_jobs_ended == 5);
  CHECK(hooked == std::vector<unsigned>{1, 1, 1, 1, 1});
  CHECK(fault_count(Module::schedule, static_cast<std::uint8_t>(ScheduleFault::overrun)) == before + 5);
  CHECK(host::watchdog_fed());  // it does complete jobs
}

TEST_CASE("a job that ends at the instant of its next release is no overrun") {
  prepare(kMillisecond, 8 * kMillisecond);
  REQUIRE(host::run(100 * kMillisecond));
  CHECK(overruns(1) == 0);
  CHECK(slow_jobs_ended == 10);
}

TEST_CASE("the watchdog starves when a bucket completes no job for the stated number of its periods") {
  prepare(5 * kMillisecond, kMillisecond);  // the fast bucket takes all the time there is
  REQUIRE(host::run(30 * kMillisecond));
  CHECK(host::watchdog_fed());
  prepare(5 * kMillisecond, kMillisecond);
  REQUIRE(host::run(100 * kMillisecond));
  CHECK(slow_jobs_ended == 0);
  CHECK_FALSE(host::watchdog_fed());
}

TEST_CASE("the watchdog is fed again once the bucket recovers") {
  prepare(5 * kMillisecond, kMillisecond);
  host::interrupt_at(102 * kMillisecond, [] { fast_work = kMillisecond; });
  REQUIRE(host::run(100 * kMillisecond));
  CHECK_FALSE(host::watchdog_fed());
  prepare(5 * kMillisecond, kMillisecond);
  host::interrupt_at(102 * kMillisecond, [] { fast_work = kMillisecond; });
  REQUIRE(host::run(200 * kMillisecond));
  CHECK(host::watchdog_fed());
}

#endif
