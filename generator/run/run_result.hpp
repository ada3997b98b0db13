// Everything a run has shown, and whether it is as it should be.
#pragma once

#include <string>

#include "generator/run/check_wcet.hpp"
#include "generator/run/figures.hpp"
#include "generator/run/image_facts.hpp"
#include "generator/run/order.hpp"
#include "generator/run/told_loops.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/tasks/bounds.hpp"

namespace finemote::gen {

struct RunResult {
  const Robot& robot;
  const Forest& forest;
  const Schedule& schedule;
  std::string board;
  Duration duration;
  Duration shown;  ///< two hyperperiods, or the whole run where that is shorter
  ImageFacts image;
  RunRecord record;
  RunFigures figures;
  FaultTable fault_table;
  timing::RobotBounds bounds;                      ///< what a monitor in the image held it to
  std::optional<bool> schedulable = std::nullopt;  ///< as analyze says; none where it gives no answer
  Table<DeviceId, Wcet> wcets_given = {};          ///< what the analysis uses
  bool declared_hold = true;                       ///< no declared time is below its bound
  bool wcets_hold = true;                          ///< no stage took longer by itself than its WCET
  std::vector<ToldLoop> loops = {};                ///< of the image
  bool loops_hold = true;                          ///< none turned more often than its mark says
  bool traffic_holds = true;                       ///< no bus carried more than is declared
  std::vector<MeasuredWcet> wcets = {};            ///< of devices whose execution times are assumed
  OrderVerdict order = {};
  bool must_judge = false;             ///< on a board where bounds are measured
  std::uint64_t phases = 1, seed = 0;  ///< how many runs these are, and what their phases were drawn from

  [[nodiscard]] std::uint64_t overruns() const;
  [[nodiscard]] std::uint64_t violations() const;  ///< counted by the monitor
  /// No figure is above its bound, but for those that rest on an assumption that the scenario has violated before.
  [[nodiscard]] bool bounds_hold() const;
  /// No device claims its data fresher than they are, or uses some that it says are too old, but for the same.
  [[nodiscard]] bool claims_hold() const;
  /// Figures that were held against a bound, those above it, and those above one that no longer counts because the
  /// scenario violated its assumption.
  struct BoundCount {
    std::size_t judged = 0, broken = 0, excused = 0;
  };
  [[nodiscard]] BoundCount count_bounds() const;
  /// Some bound was held or broken.
  [[nodiscard]] bool is_judged() const;
  /// Every bound there could be was held or broken.
  [[nodiscard]] bool is_all_judged() const;
  /// Faults counted after the bring-up that nothing explains: no fault of a scenario before, no part that is not there.
  [[nodiscard]] std::vector<FaultCount> unexplained_faults() const;
  /// What is not as it should be in the run itself, whatever the analysis says, a few words each: overruns, resets,
  /// stops, stages out of order or longer than their WCET, declared times below their bounds, loops longer than their
  /// mark says, buses with more than is declared, faults that nothing explains, expectations that were not met, nothing
  /// judged, bounds and claims that do not hold.
  [[nodiscard]] std::vector<std::string> failures() const;
};

[[nodiscard]] const std::string& name_of(const RunResult& result, DeviceId device);

}  // namespace finemote::gen
