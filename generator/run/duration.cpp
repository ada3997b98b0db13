#include "generator/run/duration.hpp"

#include <algorithm>

namespace finemote::gen {

std::optional<Duration> hyperperiod(const Schedule& schedule, Duration limit) {
  Duration result = nanoseconds(1);
  for (const Bucket& bucket : schedule.buckets) {
    const std::int64_t factor = floor_div(bucket.period, gcd(result, bucket.period));
    if (factor > floor_div(limit, result)) return std::nullopt;
    result = factor * result;
  }
  return result;
}

Duration default_duration(const Schedule& schedule) {
  constexpr Duration kShortest = milliseconds(100);
  constexpr Duration kLongest = seconds(1);
  const auto whole = hyperperiod(schedule, kLongest);
  return whole ? std::clamp(2 * *whole, kShortest, kLongest) : kLongest;
}

}  // namespace finemote::gen
