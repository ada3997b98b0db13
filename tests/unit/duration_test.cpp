// Times add to times alone, and never wrap.
#include "generator/units/duration.hpp"

#include <concepts>
#include <limits>
#include <vector>

#include "catch.hpp"
#include "generator/units/hyperperiod.hpp"

using namespace finemote::gen;

namespace {

template <class A, class B>
concept Adds = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Subtracts = requires(A a, B b) {
  a - b;
};
template <class A, class B>
concept Multiplies = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept Compares = requires(A a, B b) {
  a < b;
};

static_assert(Adds<Duration, Duration> && Subtracts<Duration, Duration> && Compares<Duration, Duration>);
static_assert(!Adds<Duration, int> && !Adds<int, Duration> && !Subtracts<Duration, int>);
static_assert(!Compares<Duration, int> && !std::equality_comparable_with<Duration, int>);
static_assert(Multiplies<Duration, int> && Multiplies<int, Duration> && !Multiplies<Duration, Duration>);
static_assert(!std::convertible_to<int, Duration> && !std::constructible_from<Duration, std::int64_t>);
static_assert(!std::convertible_to<Duration, std::int64_t>);

}  // namespace

TEST_CASE("times are written in the unit that suits them") {
  CHECK(seconds(1) == milliseconds(1000));
  CHECK(milliseconds(1) == microseconds(1000));
  CHECK(microseconds(1).ns() == 1000);
  CHECK(3 * microseconds(50) - nanoseconds(1) == nanoseconds(149'999));
  CHECK(-nanoseconds(2) < Duration::zero());
}

TEST_CASE("times are divided as mathematics does") {
  CHECK(floor_div(nanoseconds(-1), nanoseconds(10)) == -1);
  CHECK(ceil_div(nanoseconds(11), nanoseconds(10)) == 2);
  CHECK(floor_div(nanoseconds(11), 2) == nanoseconds(5));
  CHECK(ceil_div(nanoseconds(11), 2) == nanoseconds(6));
  CHECK(round_down(nanoseconds(-11), nanoseconds(10)) == nanoseconds(-20));
  CHECK(round_up(nanoseconds(11), nanoseconds(10)) == nanoseconds(20));
  CHECK(is_multiple(milliseconds(10), milliseconds(5)));
  CHECK_FALSE(is_multiple(milliseconds(5), milliseconds(10)));
  CHECK(gcd(milliseconds(6), milliseconds(4)) == milliseconds(2));
  CHECK(lcm(milliseconds(6), milliseconds(4)) == milliseconds(12));
}

TEST_CASE("a time that leaves 64 bits throws") {
  CHECK_THROWS_AS(Duration::max() + nanoseconds(1), Overflow);
  CHECK_THROWS_AS(-Duration::max() - nanoseconds(2), Overflow);
  CHECK_THROWS_AS(Duration::max() * 2, Overflow);
  CHECK_THROWS_AS(seconds(std::numeric_limits<std::int64_t>::max()), Overflow);
  CHECK_THROWS_AS(lcm(Duration::max(), Duration::max() - nanoseconds(1)), Overflow);
}

namespace {

struct Periodic {
  Duration period;
};

}  // namespace

TEST_CASE("a hyperperiod is the least common multiple of all periods, up to a limit") {
  const std::vector<Periodic> some{{milliseconds(4)}, {milliseconds(6)}, {milliseconds(10)}};
  CHECK(hyperperiod(some) == milliseconds(60));
  CHECK(hyperperiod(some, milliseconds(60)) == milliseconds(60));
  CHECK_FALSE(hyperperiod(some, milliseconds(59)));
  CHECK(two_hyperperiods(some, milliseconds(120)) == milliseconds(120));
  CHECK(two_hyperperiods(some, milliseconds(1000)) == milliseconds(120));
  CHECK(two_hyperperiods(some, milliseconds(119)) == milliseconds(119));
  CHECK(hyperperiod(std::vector<Periodic>{}) == nanoseconds(1));
  const std::int64_t large = std::int64_t{1} << 62;
  CHECK(common_multiple(nanoseconds(large), nanoseconds(2)) == nanoseconds(large));
  CHECK_FALSE(common_multiple(nanoseconds(large), nanoseconds(3)));
  CHECK_FALSE(common_multiple(std::nullopt, nanoseconds(3)));
}
