// A simulated run to a Chrome trace, which Perfetto and chrome://tracing open.
#pragma once

#include <iosfwd>
#include <vector>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen {

/// Writes the trace event format (JSON object form) as the run goes on: one track per bucket with the job as a slice
/// and its stages nested in it, one track per bus with the interrupts of all its sources, one for the
/// release interrupt, and a flow arrow for every hand-over of data.
/// Timestamps are microseconds with three decimals. The document is complete after close().
class TraceWriter : public SimulationObserver {
 public:
  TraceWriter(const timing::Model& model, timing::Profile profile, std::ostream& out);
  void close();

  void job(std::size_t bucket, Duration begin, Duration end) override;
  void stage(Rank device, Stage stage, Duration begin, Duration end) override;
  void interrupt(std::size_t stream, Duration begin, Duration end) override;
  void hand_over(Rank producer, Rank consumer, Stage stage, Duration published, Duration used) override;

 private:
  /// When a stage last ran with no length; kNothing: never.
  struct LastEmpty {
    Duration update = kNothing, handle = kNothing;
  };

  void find_buses();
  void name_tracks();
  [[nodiscard]] static std::size_t bus_track(timing::BusPlace bus);
  [[nodiscard]] std::size_t job_track(std::size_t bucket) const;
  void line(const std::string& event);
  void slice(std::size_t track, const std::string& name, Duration begin, Duration end);
  [[nodiscard]] std::size_t bucket_track(Rank device) const;
  Duration& last_empty(Rank device, Stage stage);

  const timing::Model& model_;
  timing::TaskSet set_;
  std::ostream& out_;
  bool first_ = true;
  std::uint64_t flow_ = 0;
  std::vector<timing::BusPlace> bus_of_;  ///< per stream of a bus
  Table<Rank, LastEmpty> last_empty_;
};

}  // namespace finemote::gen
