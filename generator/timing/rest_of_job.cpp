#include "generator/timing/rest_of_job.hpp"

#include <algorithm>

#include "generator/timing/demand.hpp"
#include "generator/timing/repetition.hpp"

namespace finemote::gen::timing {
namespace {

/// Beyond this many instants a bound for any instant has to do.
constexpr std::int64_t kMostInstants = 2048;

}  // namespace

/// All buckets are released at multiples of their periods. Of all instants at which the place can be passed, those
/// count at which a higher-priority bucket is released, and the last one: from an instant between two of them the same
/// work arrives, but later. The whole job has ended by its response time, which is the longer after the instant the
/// sooner that is.
Duration RestOfJob::from(std::size_t bucket, Duration work, std::size_t stage, Duration latest,
                         const std::function<Duration(Duration release)>& of) const {
  if (work == Duration::zero() && !asks(bucket, stage)) return {};
  const Duration response = responses_.bucket[bucket];
  const Duration repeat = hyperperiod_to(set_, bucket).value_or(kNever);
  if (instants(bucket, repeat, latest) > kMostInstants) return std::min(at(bucket, work, stage, {}), response);
  Duration worst;
  for (Duration release; release < repeat; release += set_.buckets[bucket].period) {
    Duration before = release;
    for (const Duration instant : instants_of(bucket, release, of(release))) {
      worst = std::max(worst, std::min(at(bucket, work, stage, instant), response - (before - release)));
      before = instant;
    }
  }
  return worst;
}

/// Of the job released at `release`, in the order of time.
std::vector<Duration> RestOfJob::instants_of(std::size_t bucket, Duration release, Duration latest) const {
  std::vector<Duration> instants{release + latest};
  for (std::size_t v = 0; v < bucket; ++v) {
    const Duration step = set_.buckets[v].period;
    for (Duration next = round_down(release, step) + step; next < release + latest; next += step)
      instants.push_back(next);
  }
  std::sort(instants.begin(), instants.end());
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  return instants;
}

std::int64_t RestOfJob::instants(std::size_t bucket, Duration repeat, Duration latest) const {
  if (repeat == kNever) return kMostInstants + 1;
  const std::int64_t jobs = floor_div(repeat, set_.buckets[bucket].period);
  if (jobs > kMostInstants) return kMostInstants + 1;
  std::int64_t in_one_job = 1;
  for (std::size_t v = 0; v < bucket && in_one_job <= kMostInstants; ++v)
    in_one_job += floor_div(latest, set_.buckets[v].period) + 1;
  return jobs * std::min(in_one_job, kMostInstants + 1);
}

bool RestOfJob::asks(std::size_t bucket, std::size_t stage) const {
  const std::vector<Stream>& streams = set_.inside_job(bucket);
  return std::any_of(streams.begin(), streams.end(), [stage](const Stream& stream) {
    return std::any_of(stream.raised.begin(), stream.raised.end(),
                       [stage](const Raised& raised) { return raised.in({stage}) > 0; });
  });
}

Duration RestOfJob::at(std::size_t bucket, Duration work, std::size_t stage, Duration instant) const {
  Demand demand(effort_);
  demand.add_streams(set_.inside_job(bucket));
  demand.run({stage});
  for (std::size_t v = 0; v < bucket; ++v) {
    const Duration period = set_.buckets[v].period;
    demand.add({round_up(instant, period) - instant, period, set_.buckets[v].cost});
  }
  return least_fit(demand, work, std::max(work, nanoseconds(1)), kLongest);
}

}  // namespace finemote::gen::timing
