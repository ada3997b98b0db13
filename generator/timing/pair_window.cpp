#include "generator/timing/pair_window.hpp"

#include <algorithm>

#include "generator/timing/demand.hpp"

namespace finemote::gen::timing {

PairWindow::PairWindow(const ProfileAnalysis& profile, Effort& effort)
    : profile_(profile),
      effort_(effort),
      updates_from_(profile.set.update.size()),
      handles_to_(profile.set.update.size()) {
  for (const TaskBucket& bucket : profile.set.buckets) {
    Duration updates, handles;
    for (auto d = bucket.devices.rbegin(); d != bucket.devices.rend(); ++d) {
      updates_from_[*d] = updates += profile.set.update[*d];
      handles_to_[*d] = handles += profile.set.handle[*d];
    }
  }
}

/// Of a higher-priority bucket, after the release of `of` and before that release is `length` old. Where the release
/// may be any, as many as fit, wherever it is.
std::int64_t PairWindow::releases_inside(std::size_t bucket, std::size_t of, Duration release, Duration length) const {
  const Duration period = profile_.set.buckets[bucket].period;
  if (profile_.table.is_general(of)) return ceil_div(length, period);
  return floor_div(release + length, period) - floor_div(release, period);
}

/// From an instant at which nothing is pending of higher priority than what begins there until handle(to) has ended.
/// @param work     of the jobs that are there, as far as it is done until then
/// @param streams  interrupts of such a window
/// @param stages   of the job of `to` that run in it
Duration PairWindow::until(Rank to, Duration release, Duration work, const std::vector<Stream>& streams,
                           const Stages& stages) const {
  const TaskSet& set = profile_.set;
  const std::size_t w = set.bucket_of[to];
  const Duration response = profile_.table.r_minus(to, release);
  const Duration extra = nanoseconds(set.handle[to] == Duration::zero() ? 1 : 0);
  Demand demand(effort_);
  demand.add_streams(streams);
  demand.run(stages);
  const Duration length = response - nanoseconds(1) + extra;
  for (std::size_t v = 0; v < w; ++v)
    demand.add({{}, set.buckets[v].period, set.buckets[v].cost, releases_inside(v, w, release, length)});
  const Duration base = work + extra;
  return std::min(least_fit(demand, base, std::max(base, nanoseconds(1)), kLongest) - extra, response);
}

Duration PairWindow::in_one_job(Rank from, Rank to, Duration release) const {
  const TaskSet& set = profile_.set;
  const std::size_t w = set.bucket_of[to];
  if (profile_.responses.closed_form[w]) return profile_.table.r_minus(to, release);
  const Stages stages{set.update_place(from), set.handle_place(to)};
  return until(to, release, updates_from_[from] + handles_to_[to], set.inside_job(w), stages);
}

bool PairWindow::spans(std::size_t from, std::size_t to) const {
  return profile_.result.profile == Profile::target && from < to && !profile_.responses.closed_form[to];
}

/// Work of jobs of a bucket that are released with `of`, or before and may not have ended: a job ends within its
/// period.
Duration PairWindow::pending_at(std::size_t bucket, std::size_t of, Duration release) const {
  const TaskBucket& task = profile_.set.buckets[bucket];
  if (profile_.table.is_general(of)) return 2 * task.cost;
  const Duration last = round_down(release, task.period), age = release - last;
  const Duration before = age == Duration::zero() ? task.period : age;  // since the last release before this one
  const bool is_left = profile_.responses.bucket[bucket] > before;
  return ((age == Duration::zero() ? 1 : 0) + (is_left ? 1 : 0)) * task.cost;
}

/// When update(from) begins nothing is pending of higher priority than its job, and no masked section of others goes
/// on. Until handle(to) has ended there run: the rest of that job; what is pending of buckets between the two; the job
/// of `to`; higher-priority jobs that are released meanwhile, after the common release; and interrupts, as in any
/// window, because what is left of other jobs may have caused some.
Duration PairWindow::in_two_jobs(Rank from, Rank to, Duration release) const {
  const TaskSet& set = profile_.set;
  const std::size_t f = set.bucket_of[from], w = set.bucket_of[to];
  const TaskBucket& first = set.buckets[f];
  Duration work = updates_from_[from] + handles_to_[first.devices.front()] + first.after;
  work += profile_.responses.b_minus[to];
  for (std::size_t v = f + 1; v < w; ++v) work += pending_at(v, w, release);
  return until(to, release, work, set.streams, {});
}

}  // namespace finemote::gen::timing
