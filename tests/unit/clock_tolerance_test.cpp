// How long what a clock counts can take where it is off, to the safe side.
#include "generator/units/clock_tolerance.hpp"

#include "catch.hpp"
#include "unit/duration_literals.hpp"

using namespace finemote::gen;

TEST_CASE("a clock without tolerance counts as it is") {
  for (const Duration span : {Duration::zero(), 1_ns, 14_ms, Duration::max()}) {
    CHECK(longest_time(span, 0) == span);
    CHECK(shortest_time(span, 0) == span);
  }
}

TEST_CASE("a slow clock takes longer, rounded up, a fast one less, rounded down") {
  CHECK(longest_time(99_ms, 10'000) == 100_ms);
  CHECK(longest_time(1_ns, 50) == 2_ns);
  CHECK(longest_time(10_ms, 50) == nanoseconds(10'000'501));  // 10 ms / 0.99995 = 10'000'500.025 ns
  CHECK(shortest_time(14_ms, 10'000) == nanoseconds(13'860'000));
  CHECK(shortest_time(1_ns, 50) == Duration::zero());
  CHECK(shortest_time(nanoseconds(20'001), 50) == nanoseconds(19'999));  // 19'999.99995 ns
}

TEST_CASE("both ends hold for every time and both readings of a tolerance, and times of years do not wrap") {
  for (const std::int64_t ppm : {1, 50, 9'999, 10'000, 500'000}) {
    for (const std::int64_t ns : {1LL, 7LL, 999'983LL, 14'000'000LL, 86'400'000'000'000LL, 100'000'000'000'000'000LL}) {
      INFO(ppm << " ppm of " << ns << " ns");
      const long double share = static_cast<long double>(ppm) / 1e6L, longest = ns / (1 - share);
      const auto up = longest_time(nanoseconds(ns), ppm).ns(), down = shortest_time(nanoseconds(ns), ppm).ns();
      CHECK(static_cast<long double>(up) >= longest * (1 - 1e-15L));
      CHECK(static_cast<long double>(up) < longest * (1 + 1e-15L) + 1);
      CHECK(static_cast<long double>(up) >= ns * (1 + share) * (1 - 1e-15L));
      CHECK(static_cast<long double>(down) <= ns * (1 - share) * (1 + 1e-15L));
      CHECK(static_cast<long double>(down) > ns * (1 - share) * (1 - 1e-15L) - 1);
    }
  }
  CHECK_THROWS_AS(longest_time(Duration::max(), 50), Overflow);
}
