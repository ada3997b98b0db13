// Runs the schedule of a model event by event with random execution times and interrupts, and keeps the worst it saw.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/timing/result.hpp"

namespace finemote::gen {

struct ChainEnds {
  Rank from, to;
};

struct SimulationOptions {
  std::uint64_t seed = 1;
  Duration duration = seconds(1);
  timing::Profile profile = timing::Profile::tight;  ///< which costs and interrupts are simulated
  std::vector<ChainEnds> chains;
  /// A run ends here at the latest. A step is an event, a piece of work up to the next one, or a value handed on.
  std::int64_t most_steps = 100'000'000;
  /// And here: interrupts that wait, as they arrive faster than they are served.
  std::size_t most_waiting = 1'000'000;
};

/// What a run reports while it goes on; for traces.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  enum class Stage { update, handle };
  virtual void job(std::size_t bucket, Duration begin, Duration end) = 0;
  virtual void stage(Rank device, Stage stage, Duration begin, Duration end) = 0;
  virtual void interrupt(std::size_t stream, Duration begin, Duration end) = 0;
  /// Data published by a stage of `producer` that ended at `published`, read by a stage that began at `used`.
  virtual void hand_over(Rank producer, Rank consumer, Stage stage, Duration published, Duration used) = 0;
};

/// Of what has not happened: below every time.
inline constexpr Duration kNothing = nanoseconds(-1);

struct Simulation {
  struct DeviceWorst {
    Duration update_response = kNothing;  ///< release to end of update(); kNothing: never ran
    Duration response = kNothing;         ///< release to end of handle()
    Duration window = kNothing;           ///< start of update() to end of handle()
  };
  struct ChainWorst {
    ChainEnds ends;
    Duration latency = kNothing;  ///< start of the source's update() to end of the terminal's handle()
  };
  Duration duration;  ///< simulated time: shorter than what was asked for where the steps did not suffice
  Table<Rank, DeviceWorst> devices;
  std::vector<ChainWorst> chains;
  std::int64_t misses = 0;  ///< jobs that ended after the next release of their bucket, and the releases they skipped
};

/// At one instant, ended stages publish, then releases and interrupts are admitted, then the most urgent work runs.
/// Where the analysis says so (TaskSet::least_lag), what takes no time at one instant runs in the order of the data.
/// Stages read at their start and publish at their end. Execution times and arrivals change their manner now and then:
/// all worst, all best, uniform, either extreme; interrupts as fast as allowed, in bursts at releases, at random.
/// The same seed gives the same run on every machine. Requires a model that read_model accepts. Throws Overflow.
Simulation simulate(const timing::Model& model, const SimulationOptions& options,
                    SimulationObserver* observer = nullptr);

}  // namespace finemote::gen
