#include "generator/run/figures.hpp"

namespace finemote::gen {
namespace {

void merge(Statistics& all, const Statistics& more) { all = together(all, more); }

void merge(Measured& all, const Measured& more) { merge(all.observed, more.observed); }

}  // namespace

RunFigures figures_of(const Robot& robot, const Forest& forest, const timing::Timing* timing, const RunRecord& record,
                      bool is_bound) {
  RunFigures figures;
  for (const DeviceId device : robot.devices.ids()) {
    figures.stages.push_back(
        {summarize(stage_times(record, device, false)), summarize(stage_times(record, device, true))});
  }
  if (timing == nullptr) return figures;
  figures.chains = measure_chains(robot, forest, *timing, record, is_bound);
  if (is_bound) figures.responses = measure_responses(robot, forest, *timing, record);
  return figures;
}

void merge(RunFigures& all, const RunFigures& more) {
  for (const DeviceId device : all.stages.ids()) {
    for (std::size_t stage = 0; stage < 2; ++stage) merge(all.stages[device][stage], more.stages[device][stage]);
  }
  for (std::size_t i = 0; i < all.chains.size(); ++i) {
    MeasuredChain& chain = all.chains[i];
    const MeasuredChain& other = more.chains[i];
    merge(chain.acquire, other.acquire);
    merge(chain.decide, other.decide);
    merge(chain.wire, other.wire);
    merge(chain.end_to_end, other.end_to_end);
  }
  for (std::size_t i = 0; i < all.responses.size(); ++i) {
    merge(all.responses[i].update, more.responses[i].update);
    merge(all.responses[i].handle, more.responses[i].handle);
    merge(all.responses[i].jitter, more.responses[i].jitter);
  }
}

}  // namespace finemote::gen
