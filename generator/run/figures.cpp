#include "generator/run/figures.hpp"

#include "generator/run/measure.hpp"

namespace finemote::gen {
namespace {

void merge(Statistics& all, const Statistics& more) { all = together(all, more); }

void merge(Measured& all, const Measured& more) { merge(all.observed, more.observed); }

template <class Of, class Figures>
void merge(std::vector<Of>& all, const std::vector<Of>& more, const Figures& figures) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& figure : figures) merge(all[i].*figure.measured, more[i].*figure.measured);
  }
}

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
  if (is_bound) figures.claims = measure_claims(robot, forest, record);
  if (is_bound) figures.traffic = measure_traffic(robot, timing->model, record);
  if (is_bound) figures.pins = measure_pins(robot, timing->model, record);
  return figures;
}

void merge(RunFigures& all, const RunFigures& more) {
  for (const DeviceId device : all.stages.ids()) {
    for (std::size_t stage = 0; stage < 2; ++stage) merge(all.stages[device][stage], more.stages[device][stage]);
  }
  merge(all.chains, more.chains, kChainFigures);
  merge(all.responses, more.responses, kResponseFigures);
  for (std::size_t i = 0; i < all.claims.size(); ++i) merge(all.claims[i].lead, more.claims[i].lead);
  merge_judged(all.traffic, more.traffic);
  merge_judged(all.pins, more.pins);
}

}  // namespace finemote::gen
