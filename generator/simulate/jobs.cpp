#include "generator/simulate/jobs.hpp"

#include <algorithm>
#include <tuple>

namespace finemote::gen {

void JobState::start(Duration at) {
  *this = {};
  active = true;
  release = at;
}

std::int64_t JobState::released(Duration at) {
  if (!active) return start(at), 0;
  if (next) return 1;
  next = at;
  return 0;
}

std::int64_t JobState::end(Duration now, Duration period) {
  active = false;
  const bool is_late = now - release > period;
  if (is_late) return next ? 2 : 1;
  if (next) start(*next);
  return 0;
}

Pieces::Pieces(const timing::TaskSet& set, const timing::TaskBucket& bucket) : bucket_(bucket) {
  worst_.push_back(bucket.before);
  for (const Rank d : bucket.devices) worst_.push_back(set.update[d]);
  for (auto d = bucket.devices.rbegin(); d != bucket.devices.rend(); ++d) worst_.push_back(set.handle[*d]);
  if (bucket.after > Duration::zero()) worst_.push_back(bucket.after);
  untimed_from_ = worst_.size();
  while (untimed_from_ > 0 && worst_[untimed_from_ - 1] == Duration::zero()) --untimed_from_;
}

namespace {

/// Smaller ones go first.
using Turn = std::tuple<bool, bool, std::int64_t>;

Turn turn_of(const JobState& job, const Pieces& pieces, Duration now) {
  const bool is_new = job.release == now;
  if (pieces.is_entry(job.piece)) return {is_new, false, -1};
  const auto rank = static_cast<std::int64_t>(pieces.device(job.piece).value());
  return pieces.is_handle(job.piece) ? Turn{is_new, true, -rank} : Turn{is_new, false, rank};
}

}  // namespace

std::optional<std::size_t> next_without_time(const std::vector<JobState>& jobs, const std::vector<Pieces>& pieces,
                                             Duration now) {
  std::optional<std::size_t> first;
  for (std::size_t w = 0; w < jobs.size(); ++w) {
    const JobState& job = jobs[w];
    if (!job.active) continue;
    const bool takes_none = !job.piece_begun && pieces[w].worst(job.piece) == Duration::zero();
    if (takes_none && (!first || turn_of(job, pieces[w], now) < turn_of(jobs[*first], pieces[*first], now))) first = w;
    if (!pieces[w].take_no_time_from(job.piece)) break;
  }
  return first;
}

Duration ReleaseClock::next() const {
  const auto soonest = std::min_element(next_.begin(), next_.end());
  return soonest == next_.end() ? Duration::max() : *soonest;
}

ReleaseClock::Due ReleaseClock::take(Duration now) {
  Due due;
  for (std::size_t w = 0; w < next_.size(); ++w) {
    if (next_[w] > now) continue;
    due.buckets.push_back(w);
    due.released = next_[w];
    next_[w] += buckets_[w].period;
  }
  return due;
}

}  // namespace finemote::gen
