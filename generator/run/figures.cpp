#include "generator/run/figures.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

void merge(Statistics& all, const Statistics& more) { all = together(all, more); }

void merge(Measured& all, const Measured& more) {
  merge(all.observed, more.observed);
  all.was_broken |= more.was_broken;
}

template <class Of, class Figures>
void merge(std::vector<Of>& all, const std::vector<Of>& more, const Figures& figures) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& figure : figures) merge(all[i].*figure.measured, more[i].*figure.measured);
  }
}

/// Of everything that is held to a bound.
RunFigures bound_figures(const Robot& robot, const Forest& forest, const Schedule& schedule,
                         const timing::Timing& timing, const RunRecord& record, const StageRuns& runs) {
  RunFigures figures;
  figures.chains = measure_chains(robot, forest, timing, record, runs, true);
  figures.responses = measure_responses(robot, forest, schedule, timing, record, runs);
  figures.claims = measure_claims(robot, forest, timing, record, runs);
  return figures;
}

/// What there was before the scenario violated an assumption.
RunRecord undisturbed(RunRecord record) {
  const Duration end = *record.violated_from;
  std::erase_if(record.events, [&](const Event& event) { return event.at >= end; });
  std::erase_if(record.parts, [&](const PartRecord& event) { return event.at() >= end; });
  std::erase_if(record.uses, [&](const SampleUse& use) { return picoseconds_down(use.at_ps) >= end; });
  record.scripted_resets = 0;  // they violate one
  record.judged_for = std::max(end - record.ready, Duration::zero());
  return record;
}

template <class Of, class Figures>
void note_broken(std::vector<Of>& all, const std::vector<Of>& before, const Figures& figures) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& figure : figures)
      (all[i].*figure.measured).was_broken = (before[i].*figure.measured).judged() == Judgement::broken;
  }
}

void note_broken(RunFigures& figures, const RunFigures& before) {
  note_broken(figures.chains, before.chains, kChainFigures);
  note_broken(figures.responses, before.responses, kResponseFigures);
  note_broken(figures.claims, before.claims, kClaimFigures);
}

}  // namespace

RunFigures figures_of(const Robot& robot, const Forest& forest, const Schedule& schedule, const timing::Timing* timing,
                      const RunRecord& record, bool is_bound) {
  const StageRuns runs(record, robot.devices.size());
  RunFigures figures;
  if (timing != nullptr && is_bound) {
    figures = bound_figures(robot, forest, schedule, *timing, record, runs);
    if (record.violated_from) {
      const RunRecord before = undisturbed(record);
      const StageRuns runs_before(before, robot.devices.size());
      note_broken(figures, bound_figures(robot, forest, schedule, *timing, before, runs_before));
    }
    figures.traffic = measure_traffic(robot, timing->model, record);
    figures.pins = measure_pins(robot, timing->model, record);
  } else if (timing != nullptr) {
    figures.chains = measure_chains(robot, forest, *timing, record, runs, false);
  }
  for (const DeviceId device : robot.devices.ids()) {
    figures.stages.push_back({summarize(stage_times(record, runs.of(device, false))),
                              summarize(stage_times(record, runs.of(device, true)))});
  }
  return figures;
}

void merge(RunFigures& all, const RunFigures& more) {
  for (const DeviceId device : all.stages.ids()) {
    for (std::size_t stage = 0; stage < 2; ++stage) merge(all.stages[device][stage], more.stages[device][stage]);
  }
  merge(all.chains, more.chains, kChainFigures);
  merge(all.responses, more.responses, kResponseFigures);
  merge(all.claims, more.claims, kClaimFigures);
  merge_judged(all.traffic, more.traffic);
  merge_judged(all.pins, more.pins);
}

}  // namespace finemote::gen
