#include "generator/report/timeline.hpp"

#include <algorithm>

#include "generator/report/frames.hpp"
#include "generator/units/hyperperiod.hpp"

namespace finemote::gen::report {
namespace {

constexpr Duration kLongest = seconds(10);  // that is shown

/// Long enough that about as many stages begin as can be shown, and at most `longest`.
Duration shown_of(const timing::TaskSet& set, Duration longest) {
  double per_ns = 0;
  for (const timing::TaskBucket& bucket : set.buckets)
    per_ns += 2 * static_cast<double>(bucket.devices.size()) / static_cast<double>(bucket.period.ns());
  const double most = TimelineRecorder::kMostStages / std::max(per_ns, 1e-12);
  if (most >= static_cast<double>(longest.ns())) return longest;
  return nanoseconds(std::max(static_cast<std::int64_t>(most), std::int64_t{1}));
}

}  // namespace

TimelineRecorder::TimelineRecorder(const timing::Model& model, timing::Profile profile) : model_(model) {
  const timing::TaskSet set = timing::make_task_set(model, profile);
  for (const timing::TaskBucket& bucket : set.buckets) kept_.periods.push_back(bucket.period);
  for (const timing::Stream& source : set.sources) kept_.streams.push_back(source.name);
  kept_.streams.emplace_back("release");
  kept_.hyperperiod = hyperperiod(model.devices);
  kept_.length = shown_of(set, two_hyperperiods(model.devices, kLongest));
}

Timeline TimelineRecorder::timeline() const {
  Timeline timeline = kept_;
  timeline.frames = frames_of(model_, kept_);
  return timeline;
}

void TimelineRecorder::job(std::size_t bucket, Duration begin, Duration end) {
  if (begin < kept_.length) kept_.jobs.push_back({bucket, begin, end});
}

void TimelineRecorder::stage(Rank device, Stage stage, Duration begin, Duration end) {
  if (begin < kept_.length) kept_.stages.push_back({device, stage == Stage::handle, begin, end});
}

void TimelineRecorder::interrupt(std::size_t stream, Duration begin, Duration end) {
  if (begin < kept_.length) kept_.interrupts.push_back({stream, begin, end});
}

}  // namespace finemote::gen::report
