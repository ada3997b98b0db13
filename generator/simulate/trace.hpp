// A simulated run to a Chrome trace, which Perfetto and chrome://tracing open.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen {

/// Writes the trace event format (JSON object form): one track per bucket with the job as a slice and its stages nested
/// in it, one track per bus with the interrupts of all its sources, one for the release interrupt, and a flow arrow for
/// every hand-over of data.
/// Timestamps are microseconds with three decimals. Everything is written at close(), in the order of time: Perfetto
/// nests slices, and ties arrows to them, in the order in which it reads.
class TraceWriter : public SimulationObserver {
 public:
  TraceWriter(const timing::Model& model, timing::Profile profile, std::ostream& out);
  void close();

  void job(std::size_t bucket, Duration begin, Duration end) override;
  void stage(Rank device, Stage stage, Duration begin, Duration end) override;
  void interrupt(std::size_t stream, Duration begin, Duration end) override;
  void hand_over(Rank producer, Rank consumer, Stage stage, Duration published, Duration used) override;

 private:
  /// A slice of no length.
  struct Empty {
    Duration at = kNothing;  ///< kNothing: there is none
    std::size_t line = 0;
  };
  /// Where a stage last ran with no length.
  struct LastEmpty {
    Empty update, handle;
  };

  struct Line {
    Duration at;
    bool is_inside;     ///< of what begins at the same time, after the slice around it
    std::size_t order;  ///< of what is equal in both
    std::string text;
  };

  void find_buses();
  void name_tracks();
  [[nodiscard]] static std::size_t bus_track(timing::BusPlace bus);
  [[nodiscard]] std::size_t job_track(std::size_t bucket) const;
  void add(Duration time, bool is_inside, std::string text);
  void add_behind(std::size_t line, std::string text);
  void slice(std::size_t track, const std::string& name, Duration begin, Duration end, bool is_inside);
  [[nodiscard]] std::size_t bucket_track(Rank device) const;
  Empty& last_empty(Rank device, Stage stage);

  const timing::Model& model_;
  timing::TaskSet set_;
  std::ostream& out_;
  std::vector<Line> lines_;
  std::uint64_t flow_ = 0;
  std::vector<timing::BusPlace> bus_of_;  ///< per interrupt source of a bus
  Table<Rank, LastEmpty> last_empty_;
};

}  // namespace finemote::gen
