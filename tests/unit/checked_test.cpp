// Arithmetic in 64 bits that rounds down and never wraps.
#include "generator/units/checked.hpp"

#include <limits>

#include "catch.hpp"
#include "generator/units/divider.hpp"

using namespace finemote::gen;

TEST_CASE("division rounds to minus infinity, with and without a prepared divisor") {
  CHECK(floor_div(-1, 10) == -1);
  CHECK(floor_div(-10, 10) == -1);
  CHECK(ceil_div(-9, 10) == 0);
  CHECK(ceil_div(11, 10) == 2);
  const std::int64_t most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t divisor : {std::int64_t{1}, std::int64_t{3}, std::int64_t{10}, std::int64_t{1'000'003},
                                     std::int64_t{60'000'000'000}, std::int64_t{1} << 40, most}) {
    const Divider divider(divisor);
    for (std::int64_t base :
         {std::int64_t{0}, divisor, std::int64_t{7'777'777'777}, most / 3, most / 3 / divisor * divisor, most - 2}) {
      for (const std::int64_t sign : {1, -1}) {
        for (std::int64_t near = -2; near <= 2; ++near) {
          const std::int64_t a = sign * (base - 2) + near;
          CHECK(divider.floor(a) == floor_div(a, divisor));
          CHECK(divider.rest(a) == a - floor_div(a, divisor) * divisor);
        }
      }
    }
  }
}

TEST_CASE("what leaves 64 bits throws, and what just fits does not") {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  CHECK(add(kMost, -1) == kMost - 1);
  CHECK_THROWS_AS(add(kMost, 1), Overflow);
  CHECK(subtract(kLeast + 1, 1) == kLeast);
  CHECK_THROWS_AS(subtract(kLeast, 1), Overflow);
  CHECK(multiply(kMost / 2, 2) == kMost - 1);
  CHECK_THROWS_AS(multiply(kMost / 2 + 1, 2), Overflow);
  CHECK(round_down(-11, 10) == -20);
  CHECK(round_up(-11, 10) == -10);
  CHECK_THROWS_AS(round_up(kMost, 10), Overflow);
  CHECK(lcm(6, 4) == 12);
  CHECK_THROWS_AS(lcm(kMost, kMost - 1), Overflow);
}
