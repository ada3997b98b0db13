#include "generator/run/duration.hpp"

#include <algorithm>

#include "generator/units/hyperperiod.hpp"

namespace finemote::gen {

Duration default_duration(const Schedule& schedule) {
  constexpr Duration kShortest = milliseconds(100);
  constexpr Duration kLongest = seconds(1);
  return std::max(two_hyperperiods(schedule.buckets, kLongest), kShortest);
}

}  // namespace finemote::gen
