// The first part of a simulated run to what a timeline of the processor and the buses shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/simulate/simulate.hpp"
#include "generator/timing/task_set.hpp"

namespace finemote::gen::report {

struct Timeline {
  struct Job {
    std::size_t bucket = 0;
    Duration begin, end;
  };
  struct Stage {
    Rank device;
    bool is_handle = false;
    Duration begin, end;  ///< with what preempted it
  };
  struct Interrupt {
    std::size_t stream = 0;
    Duration begin, end;
  };
  /// On the wire, at its longest.
  struct Frame {
    timing::BusPlace bus;
    bool is_received = false;    ///< on the receive line of a bus with two
    bool is_asked_for = true;    ///< by a stage or job; else a part sends it by itself
    std::optional<Rank> device;  ///< none: a flush
    std::size_t flush = 0;       ///< its place in the model
    Duration begin, end;
  };
  std::optional<Duration> hyperperiod;  ///< of the buckets; none where it is longer than a Duration holds
  Duration length;                      ///< shown: the first two of them, or what of these is not too much to draw
  std::vector<Duration> periods;
  std::vector<std::string> streams;
  std::vector<Job> jobs;
  std::vector<Stage> stages;
  std::vector<Interrupt> interrupts;
  std::vector<Frame> frames;
};

/// Keeps what begins in the time that is shown.
class TimelineRecorder : public SimulationObserver {
 public:
  static constexpr std::int64_t kMostStages = 10'000;  ///< shown, about

  TimelineRecorder(const timing::Model& model, timing::Profile profile);

  /// What was kept, with the frames that it puts on the buses.
  [[nodiscard]] Timeline timeline() const;

  void job(std::size_t bucket, Duration begin, Duration end) override;
  void stage(Rank device, Stage stage, Duration begin, Duration end) override;
  void interrupt(std::size_t stream, Duration begin, Duration end) override;
  void hand_over(Rank, Rank, Stage, Duration, Duration) override {}

 private:
  const timing::Model& model_;
  Timeline kept_;
};

}  // namespace finemote::gen::report
