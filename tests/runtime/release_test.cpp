// The release plan against arithmetic: bucket i is due exactly at the multiples of its period.
#include <algorithm>
#include <vector>

#include "catch.hpp"
#include "runtime/src/release.hpp"

namespace {

using namespace finemote;

void nothing() {}
constexpr Bucket any_bucket[] = {{nothing, 1'000'000, 48, 4, 3}};

std::vector<Bucket> buckets_of(const std::vector<int>& periods_ms) {
  std::vector<Bucket> buckets;
  for (int period : periods_ms) buckets.push_back({nothing, period * kMillisecond, 48, 4, 3});
  return buckets;
}

void check_against_arithmetic(const std::vector<int>& periods_ms, std::uint32_t longest_step, unsigned instants) {
  const auto buckets = buckets_of(periods_ms);
  std::vector<BucketState> states(buckets.size());
  for (unsigned i = 0; i < states.size(); ++i) states[i].bit = 1U << (31 - i);
  const Buckets all{buckets.data(), buckets.size(), states.data()};
  const Schedule schedule{"x", kMillisecond, all, Overrun::skip, nothing, nothing, {}};
  detail::ReleasePlan plan;
  plan.start(schedule, longest_step);
  std::uint64_t tick = 0;
  for (unsigned n = 0; n < instants; ++n) {
    const detail::Release release = plan.next(schedule);
    std::uint32_t due = 0;
    std::uint64_t nearest = tick + longest_step;
    for (unsigned i = 0; i < buckets.size(); ++i) {
      const auto period = static_cast<std::uint64_t>(periods_ms[i]);
      if (tick % period == 0) due |= states[i].bit;
      nearest = std::min(nearest, (tick / period + 1) * period);
    }
    REQUIRE(release.due == due);
    REQUIRE(tick + release.ticks == nearest);
    tick += release.ticks;
  }
}

}  // namespace

extern "C" const Schedule finemote_schedule{"x", 1'000'000, any_bucket, Overrun::skip, nothing, nothing, nullptr};

TEST_CASE("releases fall on the multiples of each period") {
  check_against_arithmetic({5, 10}, 99, 1000);
  check_against_arithmetic({7}, 99, 1000);
  check_against_arithmetic({4, 6, 10}, 99, 1000);
  check_against_arithmetic({1, 2, 3, 5, 7, 11, 13, 17, 19, 23, 29}, 99, 100'000);
}

TEST_CASE("a long way is gone in steps the timer can count, on which nothing is due") {
  check_against_arithmetic({1000}, 99, 1000);
  check_against_arithmetic({150, 1000}, 99, 10'000);
  check_against_arithmetic({99, 100}, 99, 10'000);
}

TEST_CASE("periods are divided by ticks exactly") {
  for (const Duration period : std::initializer_list<Duration>{1LL, 999'999LL, 1'000'000LL, 1'000'001LL, 5'000'000LL,
                                                               123'456'789'012LL, INT64_MAX}) {
    for (const std::uint32_t tick : {1U, 125U, 1'000'000U, 99'864'375U, UINT32_MAX}) {
      const detail::Ticks ticks = detail::ticks_in(period, tick);
      CHECK(ticks.exact == (period % tick == 0));
      CHECK(ticks.count == std::min<Duration>(period / tick, UINT32_MAX));
    }
  }
}
