// The result of a run as a document and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "generator/run/chains.hpp"
#include "generator/run/check_wcet.hpp"
#include "generator/run/image_facts.hpp"
#include "generator/schedule/schedule.hpp"
#include "generator/timing/bounds.hpp"

namespace finemote::gen {

/// Everything a run has shown.
struct RunResult {
  const Robot& robot;
  const Forest& forest;
  const Schedule& schedule;
  std::string board;
  Duration duration;
  Duration shown;  ///< two hyperperiods, or the whole run where that is shorter
  ImageFacts image;
  RunRecord record;
  std::vector<MeasuredChain> chains;
  FaultTable fault_table;
  timing::RobotBounds bounds;                      ///< what a monitor in the image held it to
  std::optional<bool> schedulable = std::nullopt;  ///< as analyze says; none where it gives no answer
  std::vector<MeasuredWcet> wcets = {};            ///< of devices whose execution times are assumed

  [[nodiscard]] std::uint64_t overruns() const;
  [[nodiscard]] std::uint64_t violations() const;  ///< counted by the monitor
  /// Of the run itself, whatever the analysis says: no overrun, no reset, all as the scenario expects, and no figure
  /// above its bound unless it injects faults.
  [[nodiscard]] bool good() const;
};

/// `finemote.run/1` without diagnostics.
nlohmann::ordered_json run_document(const RunResult& result);

/// Sizes, observed order, chains, counters.
void print_run(const RunResult& result, std::ostream& out);

/// `flash 14032 B, RAM 3560 B, stack 1208 B (proven)`; nothing for a host executable.
void print_image(const ImageFacts& image, std::ostream& out);

/// Chrome trace for Perfetto: one track per bucket, a slice for every uninterrupted piece of a stage.
nlohmann::ordered_json run_trace(const RunResult& result);

}  // namespace finemote::gen
