#include "generator/run/responses.hpp"

#include "generator/run/measure.hpp"

namespace finemote::gen {
namespace {

std::vector<Duration> responses(const RunRecord& record, DeviceId device, bool is_handle, Duration period) {
  std::vector<Duration> list;
  for (const StageRun& run : stage_runs(record, device, is_handle)) {
    if (run.begin >= record.ready) list.push_back(record.true_time(run.end - round_down(run.begin, period)));
  }
  return list;
}

/// The spread of a series as a series of its own.
Statistics spread(const Statistics& series) {
  return series.count == 0 ? Statistics{} : summarize({series.max - series.min});
}

}  // namespace

std::vector<MeasuredResponse> measure_responses(const Robot& robot, const Forest& forest, const timing::Timing& timing,
                                                const RunRecord& record) {
  const timing::ProfileResult& bounds = timing.verdict();
  std::vector<MeasuredResponse> all;
  for (const Rank rank : forest.order.ids()) {
    const DeviceId device = forest.order[rank];
    const Duration period = robot.devices[device].period;
    MeasuredResponse one{device, {}, {}, {}};
    one.update = {summarize(responses(record, device, false, period)), bounds.devices[rank].r_plus};
    one.handle = {summarize(responses(record, device, true, period)), bounds.devices[rank].r_minus};
    one.jitter = {spread(one.handle.observed), timing::jitter_bound(timing.model, bounds, rank)};
    all.push_back(one);
  }
  return all;
}

}  // namespace finemote::gen
