#include "generator/run/responses.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

/// Releases of one bucket, each of which has its job: in their order, but where overruns were counted or the board
/// began anew, whose releases have none. A board that begins anew counts its periods from another time on.
class Releases {
 public:
  Releases(Duration period, bool has_all_jobs) : period_(period), has_all_jobs_(has_all_jobs) {}

  /// Of the next job, which began then.
  Duration take(Duration begin) {
    const Duration last = round_down(begin, period_);
    const Duration release = has_all_jobs_ ? std::min(next_, last) : last;
    next_ = release + period_;
    return release;
  }
  /// Of the job after those, where that is known.
  [[nodiscard]] std::optional<Duration> next() const { return has_all_jobs_ ? std::optional(next_) : std::nullopt; }

 private:
  Duration period_;
  bool has_all_jobs_;
  Duration next_{};
};

struct Responses {
  std::vector<Duration> seen;
  std::optional<Duration> open;  ///< of a job that had not ended by the end of the run: so far
};

Responses responses(const RunRecord& record, const std::vector<StageRun>& runs, Releases releases) {
  Responses all;
  for (const StageRun& run : runs) {
    if (record.scripted_resets > 0 && record.violated_from && run.end >= *record.violated_from)
      break;  // it is unknown when it was released
    const Duration release = releases.take(run.begin);
    if (run.begin >= record.ready) all.seen.push_back(record.true_time(run.end - release));
  }
  if (!record.stopped.empty()) return all;  // no later release comes
  const Duration end = record.ready + record.judged_for;
  const auto next = releases.next();
  if (next && end > record.ready && end > *next) all.open = record.true_time(end - *next);
  return all;
}

/// What is open counts once it is late: it may still end in time.
Measured measured(Responses responses, std::optional<Duration> bound) {
  if (bound && responses.open && *responses.open > *bound) responses.seen.push_back(*responses.open);
  return {summarize(responses.seen), bound};
}

/// The spread of a series as a series of its own.
Statistics spread(const Statistics& series) {
  return series.count == 0 ? Statistics{} : summarize({series.max - series.min});
}

}  // namespace

std::vector<MeasuredResponse> measure_responses(const Robot& robot, const Forest& forest, const Schedule& schedule,
                                                const timing::Timing& timing, const RunRecord& record,
                                                const StageRuns& runs) {
  const timing::ProfileResult& bounds = timing.verdict();
  std::vector<MeasuredResponse> all;
  for (const Rank rank : forest.order.ids()) {
    const DeviceId device = forest.order[rank];
    const std::size_t bucket = schedule.bucket_of[device];
    const bool has_overrun = bucket < record.overruns.size() && record.overruns[bucket] > 0;
    const Releases releases(robot.devices[device].period, !has_overrun && record.resets + record.scripted_resets == 0);
    MeasuredResponse one{device, {}, {}, {}};
    one.update = measured(responses(record, runs.of(device, false), releases), bounds.devices[rank].r_plus);
    one.handle = measured(responses(record, runs.of(device, true), releases), bounds.devices[rank].r_minus);
    one.jitter = {spread(one.handle.observed), timing::jitter_bound(timing.model, bounds, rank)};
    all.push_back(one);
  }
  return all;
}

}  // namespace finemote::gen
