// Mean and deviation stay where the values are.
#include "generator/run/statistics.hpp"

#include "catch.hpp"

using namespace finemote::gen;

TEST_CASE("equal values have their own mean, and no deviation") {
  const std::vector<Duration> values(9, nanoseconds(11'119));
  const Statistics one = summarize(values);
  CHECK(one.mean_ns == 11'119);
  CHECK(one.sd_ns == 0);
  const Statistics both = together(one, summarize(std::vector<Duration>(7, nanoseconds(11'119))));
  CHECK(both.mean_ns == 11'119);
  CHECK(both.sd_ns == 0);
  CHECK(both.count == 16);
}

TEST_CASE("the mean of two runs is that of all values") {
  const Statistics all = together(summarize({nanoseconds(1), nanoseconds(2)}), summarize({nanoseconds(9)}));
  CHECK(all.mean_ns == Approx(4));
  CHECK(all.sd_ns == Approx(3.559026).epsilon(1e-6));
  CHECK(all.min == nanoseconds(1));
  CHECK(all.max == nanoseconds(9));
}
