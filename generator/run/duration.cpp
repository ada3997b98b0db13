#include "generator/run/duration.hpp"

#include <algorithm>
#include <numeric>

namespace finemote::gen {

std::optional<std::int64_t> hyperperiod(const Schedule& schedule, std::int64_t limit) {
  std::int64_t result = 1;
  for (const Bucket& bucket : schedule.buckets) {
    const std::int64_t factor = bucket.period_ns / std::gcd(result, bucket.period_ns);
    if (factor > limit / result) return std::nullopt;
    result *= factor;
  }
  return result;
}

std::int64_t default_duration(const Schedule& schedule) {
  constexpr std::int64_t kShortest = 100'000'000;
  constexpr std::int64_t kLongest = 1'000'000'000;
  const auto whole = hyperperiod(schedule, kLongest);
  return whole ? std::clamp(2 * *whole, kShortest, kLongest) : kLongest;
}

}  // namespace finemote::gen
